/* B1 holds: a unicast ends within the bound. */
A[] !Clock.Late
/* B2 holds: with one slot less it does not. */
E<> Clock.Last && Police1.Awaiting
