/* I1 holds: at no moment are two awake, neither on both sides nor on one. */
A[] awake[SUPPORT] + awake[BUS] <= 1
/* I2 holds: each move wakes it once, however late its messages come. */
A[] woken[0] <= 1 && woken[1] <= 1
/* I3 holds: what is ready or wakes is whole. */
A[] ((Receiver1.Ready || Receiver1.Waking) imply has[0] == PARTS) && ((Receiver2.Ready || Receiver2.Waking) imply has[1] == PARTS)
/* I4 holds: where a plan was told that the move has failed, this move never wakes it. */
A[] (Sender1.told imply woken[0] == 0) && (Sender2.told imply woken[1] == 0)
/* I5 holds: nothing is lost: what has gone is there, or has gone on from there. */
A[] (Sender1.Gone imply (Receiver1.Ready || Receiver1.Waking || Receiver1.Telling || Receiver1.Here || Sender2.Going || Sender2.Gone || Sender2.Away)) && (Sender2.Gone imply (Receiver2.Ready || Receiver2.Waking || Receiver2.Telling || Receiver2.Here))
/* I6 holds: what is back is awake, also where its process was killed, and nothing is left of its going. */
A[] Receiver2.Here imply (awake[SUPPORT] == 1 && awake[BUS] == 0 && (Sender1.Over || Sender1.Cancelling) && !departed[SUPPORT])
/* I7 holds: what has left is not awake there. */
A[] Receiver1.Left imply (awake[BUS] == 0 && (Sender2.Going || Sender2.Gone || Sender2.Away))
/* I8 holds: an agent that came, and is about to leave, sleeps, also where its process was killed. */
A[] (Sender2.Sleeping || Sender2.Offered || Sender2.Deleted || Sender2.Going || Sender2.Gone || Sender2.Away) imply awake[BUS] == 0
/* I9 holds: an agent that came and could not leave is awake. */
A[] (Sender2.Over && Sender2.told && Receiver1.Here) imply awake[BUS] == 1
/* I10 holds: nothing is stuck. */
A[] not deadlock
/* I11 holds: it may come back. */
E<> Receiver2.Here && Sender2.Away
/* I12 holds: before its sender knows that it had arrived. */
E<> Receiver2.Ready && Sender1.Gone && Sender2.Gone
/* I13 holds: an offer that is late is answered. */
E<> Receiver1.Answering && Sender1.Gone
/* I14 holds: a G may come again when it has left. */
E<> Sender1.Away && Receiver1.Answering
/* I15 holds: an agent may be unable to leave again. */
E<> Sender2.Over && Receiver1.Here && awake[BUS] == 1
/* I16 holds: and may be killed before it is. */
E<> Sender2.Offered && Receiver1.Here
/* I17 holds: nobody is told to forget what has come back. */
A[] !(Sender1.Cancelling && Receiver2.Telling)
