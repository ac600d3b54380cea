/* N1 holds: at no moment are two awake, whoever offers the agent at its home. */
A[] awake[SUPPORT] + awake[BUS] <= 1
/* N2 holds: who has all but the token is never admitted there. */
A[] Receiver3.None || Receiver3.Unknown
/* N3 holds: each move wakes the agent once, and only after it has gone. */
A[] woken[0] <= 1 && woken[1] <= 1 && woken[2] == 0
/* N4 holds: nothing is lost: what has gone is there, or has gone on from there. */
A[] (Sender1.Gone imply (Receiver1.Ready || Receiver1.Waking || Receiver1.Telling || Receiver1.Here || Sender2.Going || Sender2.Gone || Sender2.Away)) && (Sender2.Gone imply (Receiver2.Ready || Receiver2.Waking || Receiver2.Telling || Receiver2.Here))
/* N5 holds: the agent itself comes back all the same. */
E<> Receiver2.Here && Sender2.Away
