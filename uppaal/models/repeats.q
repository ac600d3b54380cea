/* E1 holds: the receiver's host gets each message at most once. */
A[] given[1] <= 1 && given[2] <= 1
/* E2 holds: it gets nothing that was not sent. */
A[] (given[1] > 0 imply (Police1.attempt > 0)) && (given[2] > 0 imply (Police2.attempt > 0))
/* E3 holds: what is reported delivered, the host has got. */
A[] (Police1.Answered imply given[1] > 0) && (Police2.Answered imply given[2] > 0)
/* E4 holds: nothing is accepted that is older than what the host has. */
A[] (waiting[1] imply taken[SUPPORT] < 1) && (waiting[2] imply taken[SUPPORT] < 2)
/* E5 holds: nothing is stuck before all messages have ended. */
A[] deadlock imply (Police1.Over && Police2.Over && active == 0)
/* E6 holds: both messages can be delivered. */
E<> Police1.Answered && Support2.Taken && Police2.Held
/* E7 holds: a message that is given up may have arrived. */
E<> Police1.GivenUp && given[1] == 1
/* E8 holds: a message is given up only after all its attempts. */
A[] (Police1.GivenUp imply Police1.attempt == MAX_ATTEMPTS) && (Police2.GivenUp imply Police2.attempt == MAX_ATTEMPTS)
/* E9 holds: nobody begins to send while a carrier is heard. */
A[] !late
/* E10 holds: messages to one device are under way one after the other. */
A[] (Police1.New || Police1.Ready || Police1.Contending || Police1.Deferred || Police1.OnAir || Police1.Awaiting || Police1.Held) imply Police2.New
/* E11 holds: a board sends one packet at a time. */
A[] !(Answer1.OnAir && Answer2.OnAir) && !(Police1.OnAir && Police2.OnAir)
/* E12 holds: only what the host has is acknowledged. */
A[] (Answer1.OnAir imply given[1] > 0) && (Answer2.OnAir imply given[2] > 0)
/* E13 holds: an attempt has failed only after the whole patience. */
A[] (Police1.Ready || Police1.Contending || Police1.Deferred) imply Police1.left == 0
/* E14 holds: a repeat of what the host has is acknowledged again. */
E<> Answer1.OnAir && Police1.attempt == 2 && given[1] == 1
/* E15 holds: acknowledgements go before what is new. */
A[] Police1.OnAir && !collided && Answer1.Due imply started <= FRESH_SLOTS
/* E16 holds: all attempts can be used. */
E<> Police1.GivenUp && Police2.GivenUp
