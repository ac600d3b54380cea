/* Z1 holds: the original stays awake. */
A[] awake[SUPPORT] == 1
/* Z2 holds: a move makes one clone at most, however late its messages come. */
A[] woken[0] <= 1 && awake[BUS] <= 1
/* Z3 holds: where a plan was told that the move has failed, no clone comes of it. */
A[] Sender1.told imply woken[0] == 0
/* Z4 holds: what is ready or wakes is whole. */
A[] (Receiver1.Ready || Receiver1.Waking || Receiver1.Here) imply has[0] == PARTS
/* Z5 holds: what is away was awake there. */
A[] Sender1.Away imply woken[0] == 1
/* Z6 holds: nothing is stuck. */
A[] not deadlock
/* Z7 holds: a clone may come to be. */
E<> Sender1.Away && Receiver1.Here
/* Z8 holds: also where its sender does not know. */
E<> Sender1.Over && Receiver1.Here
/* Z9 holds: a clone may have ended when an offer or a G comes again. */
E<> Receiver1.Answering && Sender1.Gone
/* Z10 holds: a G may come when the move was cancelled. */
E<> Receiver1.Unknown && woken[0] == 0
/* Z11 holds: a sender may give up. */
E<> Sender1.told && Receiver1.Ready
/* Z12 holds: a clone that has ended is not awake. */
A[] (Receiver1.Left || Receiver1.Answering) imply awake[BUS] == 0
/* Z13 holds: a clone is awake, also where its process was killed. */
A[] Receiver1.Here imply awake[BUS] == 1
/* Z14 holds: a sender that was killed knows nothing of a clone. */
A[] Support.Starting imply (Sender1.Home || Sender1.Over)
/* Z15 holds: who knows nothing of a move that has gone answers so, and forgets it. */
E<> Receiver1.None && A1.UnderWay && woken[0] == 0
