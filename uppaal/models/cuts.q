/* K1 holds: the host gets a message twice only after a reset, and never after a loss of power. */
A[] given[1] > 1 imply (Fate.cuts > 0 && !Support1.lost)
/* K2 holds: what is reported delivered, the host has got. */
A[] Police1.Answered imply given[1] > 0
/* K3 holds: nothing is stuck before the message has ended. */
A[] deadlock imply (Police1.Over && active == 0)
/* K4 holds: a message can be refused as stale. */
E<> Police1.Refused
/* K5 holds: it is refused only where the receiver has lost its power. */
A[] Police1.Refused imply Support1.lost
/* K6 holds: what was on the air when its board was reset is over. */
A[] Police1.Over imply !sending[POLICE]
/* K7 holds: a message that a board had not yet known to be taken may come again. */
E<> given[1] == 2
