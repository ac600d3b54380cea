/* X1 holds: an agent that sleeps to leave is awake again in the end. */
Sender1.Offered --> Sender1.Over && awake[SUPPORT] == 1
/* X2 holds: a receiver to which nothing comes forgets the move. */
Receiver1.Coming --> Receiver1.None
/* X3 holds: nothing wakes there. */
A[] awake[BUS] == 0 && !Receiver1.Whole && has[0] == 0
/* X4 holds: what is said again and again is heard, and brings nothing. */
E<> Sender1.tries == 5 && Receiver1.Coming && W1_0.UnderWay
/* X5 holds: an offer may be lost. */
E<> kills == 0 && Sender1.Offered && Sender1.tries == 1 && underWay[0] == 0 && Receiver1.None
