/* L1 holds: each board finishes, or goes. */
Police.Begun --> Police.Finished || Police.Gone
/* L2 holds: whoever accepts the next key seals with it, or goes, however often it is BUSY. */
Police.Accepts --> Police.Seals || Police.Gone
/* L3 holds: a deletion that was begun is completed. */
Police.Leaving --> Police.Gone && underWay[0] == NOTHING
/* L4 holds: each message ends. */
underWay[0] != NOTHING --> underWay[0] == NOTHING
