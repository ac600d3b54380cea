/* C1 holds: each host gets the other's message at most once. */
A[] given[1] <= 1 && given[2] <= 1
/* C2 holds: what is reported delivered, the host has got. */
A[] (Police1.Answered imply given[1] == 1) && (Support2.Answered imply given[2] == 1)
/* C3 holds: nothing is stuck before both messages have ended. */
A[] deadlock imply (Police1.Over && Support2.Over && Answer1.Idle && Answer2.Idle)
/* C4 holds: packets may collide, and the air is free when the last has ended. */
E<> Air.Freeing && collided
/* C5 holds: both messages can be delivered. */
E<> Police1.Answered && Support2.Answered
/* C6 holds: nobody begins to send while a carrier is heard. */
A[] !late
/* C7 holds: a board sends one packet at a time, its own or an answer. */
A[] sending[POLICE] == (Police1.OnAir || Answer2.OnAir) && sending[SUPPORT] == (Support2.OnAir || Answer1.OnAir) && !(Police1.OnAir && Answer2.OnAir) && !(Support2.OnAir && Answer1.OnAir)
/* C8 holds: the air has as many carriers as there are packets. */
A[] !Air.Freeing imply onAir == (sending[POLICE] ? 1 : 0) + (sending[SUPPORT] ? 1 : 0) + (Air.Heard ? 1 : 0)
/* C9 holds: a board acknowledges while it waits for an acknowledgement, or for the air, itself. */
E<> Answer2.OnAir && Police1.Held && Answer1.Idle
/* C10 holds: an answer that was due while the air was busy is put off. */
E<> Answer1.PutOff && Support2.Contending
/* C11 holds: it goes before a message that contends. */
A[] Answer1.Pending imply (onAir > 0 && owed[1] == ACK)
/* C12 holds: nobody begins before the air was quiet for a slot. */
A[] !Early.Before
/* C13 holds: an acknowledgement may begin then. */
E<> Early.Just && Answer1.OnAir && !collided
/* C14 holds: and nothing else. */
A[] (Early.Just && !collided) imply (Answer1.OnAir || Answer2.OnAir)
