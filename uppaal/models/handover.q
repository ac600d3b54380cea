/* J1 holds: at no moment are two awake, neither on both sides nor on one. */
A[] awake[SUPPORT] + awake[BUS] <= 1
/* J2 holds: where a record says offered, gone or away, nothing is awake. */
A[] (Sender1.Sleeping || Sender1.Offered || Sender1.Going || Sender1.Gone || Sender1.Away || Sender1.Deleted || Sender2.Sleeping || Sender2.Offered || Sender2.Going || Sender2.Gone || Sender2.Away || Sender2.Deleted) imply awake[SUPPORT] == 0
/* J3 holds: of all moves of an agent one wakes it, once. */
A[] woken[0] + woken[1] <= 1
/* J4 holds: only a move that has gone wakes it there. */
A[] (woken[0] > 0 imply (Sender1.Going || Sender1.Gone || Sender1.Away)) && (woken[1] > 0 imply (Sender2.Going || Sender2.Gone || Sender2.Away))
/* J5 holds: what is ready or wakes is whole. */
A[] ((Receiver1.Ready || Receiver1.Waking || Receiver1.Telling || Receiver1.Here) imply has[0] == PARTS) && ((Receiver2.Ready || Receiver2.Waking || Receiver2.Telling || Receiver2.Here) imply has[1] == PARTS)
/* J6 holds: where a plan was told that the move has failed, this move never wakes it. */
A[] (Sender1.told || Sender1.Over) imply (woken[0] == 0 && !Receiver1.Here)
/* J7 holds: nothing is lost: what has gone is there, as a whole. */
A[] ((Sender1.Going || Sender1.Gone) imply (Receiver1.Ready || Receiver1.Waking || Receiver1.Telling || Receiver1.Here)) && ((Sender2.Going || Sender2.Gone) imply (Receiver2.Ready || Receiver2.Waking || Receiver2.Telling || Receiver2.Here))
/* J8 holds: what is away is awake there. */
A[] (Sender1.Away || Sender2.Away) imply awake[BUS] == 1
/* J9 holds: what is here is awake, also where its process was killed. */
A[] ((Receiver1.Here || Receiver2.Here) imply awake[BUS] == 1) && ((Sender1.Over && (Sender2.Home || Sender2.Over)) imply awake[SUPPORT] == 1)
/* J10 holds: nothing is stuck. */
A[] not deadlock
/* J11 holds: what is told is told by whom it concerns. */
A[] (Sender1.told imply (Sender1.Over || Sender1.Cancelling)) && (Sender1.Home imply begun == 0) && (Sender2.Home imply begun <= 1)
/* J12 holds: a move may wake it. */
E<> Sender1.Away && Receiver1.Here
/* J13 holds: it may be awake there before its sender knows. */
E<> Sender1.Gone && Receiver1.Here
/* J14 holds: the second move may wake it, though the receiver still waits in the first. */
E<> Sender2.Away && Receiver2.Here && Receiver1.Ready
/* J15 holds: or though an R of the first may still come. */
E<> Sender2.Offered && Sender1.told && R1.UnderWay && Receiver1.None
/* J16 holds: a sender may give up though its receiver is ready. */
E<> Sender1.Deleted && Receiver1.Ready && X1.Silent
/* J17 holds: a sender that was killed may have told nothing. */
E<> Sender1.Over && !Sender1.told && awake[SUPPORT] == 1
/* J18 holds: a receiver may refuse and then admit; the refusal may come when all has gone. */
E<> X1.UnderWay && Sender1.Gone && Receiver1.Here
/* J19 holds: or the sender heeds it though the receiver is ready. */
E<> X1.UnderWay && Sender1.Deleted && Receiver1.Ready
/* J20 holds: what has come of the parts may stay when the process is killed. */
E<> W1_1.UnderWay && Receiver1.None && has[0] == 1
/* J21 holds: or be lost. */
E<> W1_1.UnderWay && Receiver1.Coming && has[0] == 0
/* J22 holds: parts may come in the wrong order. */
E<> D1_0.UnderWay && D1_1.UnderWay && Receiver1.Wanting && has[0] == 0
/* J23 holds: an offer that is late may find all its parts, and make a receiver ready that was cancelled. */
E<> Receiver1.Ready && C1.UnderWay
/* J24 holds: a cancelled move may be gone from the receiver's side. */
E<> C1.UnderWay && Receiver1.None && has[0] == PARTS
/* J25 holds: an agent that is about to leave may stay, as its process is killed. */
E<> Sender1.Sleeping && awake[SUPPORT] == 0
/* J26 holds: parts that no record names may be removed. */
E<> C1.UnderWay && Receiver1.None && has[0] == 0
/* J37 holds: both moves may begin. */
E<> begun == MOVES
