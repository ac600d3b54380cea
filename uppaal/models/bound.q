/* B1 holds: a unicast ends within the bound. */
A[] !Clock.Late
