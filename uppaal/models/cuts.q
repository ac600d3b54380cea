/* K1 holds: the host gets a message twice only after a reset, and never after a loss of power. */
A[] given[1] > 1 imply (Fate.cuts > 0 && !Fate.power)
/* K2 holds: what is reported delivered, the host has got. */
A[] Ends.Delivered imply given[1] > 0
/* K3 holds: nothing is stuck before the message has ended. */
A[] deadlock imply (Police1.Over && Answer1.Idle)
/* K4 holds: a message can be below the floor. */
E<> Police1.Refused && Police1.attempt == 1
/* K5 holds: it is refused only where the receiver has lost its power. */
A[] Police1.Refused imply (Support1.lost && Fate.power)
/* K6 holds: what was on the air when its board was reset is over. */
A[] (Police1.Over imply !sending[POLICE]) && ((Police1.CutOff || Answer1.CutOff) imply collided)
/* K7 holds: a message that a board had not yet known to be taken may come again. */
E<> given[1] == 2
/* K8 holds: a host is told how its message has ended, unless its board was reset or seals it anew. */
A[] (Police1.Over && Ends.Waiting) imply Fate.cuts > 0
/* K9 holds: as undelivered only after all attempts, or below the floor. */
A[] Ends.Undelivered imply (Police1.attempt == MAX_ATTEMPTS || Support1.lost)
/* K10 holds: what has ended gives its board's turn back. */
A[] Police1.Over imply (turn[POLICE] == 0 && ended[POLICE] == 1 && active == 0)
/* K11 holds: a board that has lost its power accepts nothing that it may have had before. */
A[] (Fate.power && Support1.Queued) imply !Support1.lost
/* K12 holds: a message is delivered also after either board was reset. */
E<> Ends.Delivered && Fate.cuts > 0
/* K13 holds: a host is told of a message that was refused. */
E<> Ends.Undelivered && Support1.lost && Police1.attempt < MAX_ATTEMPTS
/* K14 holds: nothing that was on the air is left when it is quiet. */
A[] Air.Quiet imply (kind == 0 && to == NOBODY && from == NOBODY && nonce == 0 && !genuine)
/* K15 holds: a packet breaks off where its sender is reset. */
E<> Police1.CutOff
