/* L1 holds: each board finishes, or goes. */
Police.Begun --> Police.Finished || Police.Gone
/* L2 holds: whoever accepts the next key seals with it, or goes, however often it is BUSY. */
Police.Accepts --> Police.Seals || Police.Gone
/* L3 holds: a deletion that was begun is completed. */
Police.Leaving --> Police.Gone && underWay[0] == NOTHING
/* L4 holds: each message ends. */
underWay[0] != NOTHING --> underWay[0] == NOTHING
/* L5 holds: a message is sent under the old key. */
E<> Ear.Old && PoliceRadio.attempts == 1 && underWay[0] == OLD
/* L6 holds: or under the new one. */
E<> Ear.New && PoliceRadio.attempts == 1 && underWay[0] == NEW
/* L7 holds: attempts are those of the message that is under way. */
A[] (underWay[0] == NOTHING && !Police.Gone) imply PoliceRadio.attempts == 0
