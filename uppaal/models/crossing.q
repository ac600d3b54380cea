/* C1 holds: each host gets the other's message at most once. */
A[] given[1] <= 1 && given[2] <= 1
/* C2 holds: what is reported delivered, the host has got. */
A[] (Police1.Answered imply given[1] == 1) && (Support2.Answered imply given[2] == 1)
/* C3 holds: nothing is stuck before both messages have ended. */
A[] deadlock imply (Police1.Over && Support2.Over && active == 0)
/* C4 holds: packets may collide. */
E<> collided
/* C5 holds: both messages can be delivered. */
E<> Police1.Answered && Support2.Answered
/* C6 holds: nobody begins to send while a carrier is heard. */
A[] !late
/* C7 holds: a board sends one packet at a time. */
A[] !(Police1.OnAir && Answer2.OnAir) && !(Support2.OnAir && Answer1.OnAir)
