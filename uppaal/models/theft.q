/* N6 holds: it is the token that keeps a forger out: who has that wakes another at home. */
E<> Receiver2.Here && awake[SUPPORT] == 1 && awake[BUS] == 1
/* N7 holds: also where the agent has gone and is not yet awake. */
E<> Receiver2.Here && Receiver1.Ready
