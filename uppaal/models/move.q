/* J27 holds: what is there was sent. */
A[] (has[0] >= 1 imply D1_0.UnderWay) && (has[0] == PARTS imply D1_1.UnderWay)
/* J28 holds: a sender says only what it was asked, and goes on only if it was told. */
A[] ((Sender1.Going || Sender1.Gone || Sender1.Away) imply R1.UnderWay) && (Sender1.Away imply A1.UnderWay) && (Sender1.Gone imply G1.UnderWay) && (D1_0.UnderWay imply W1_0.UnderWay) && (D1_1.UnderWay imply (W1_0.UnderWay || W1_1.UnderWay)) && (C1.UnderWay imply (R1.UnderWay && (Sender1.Over || Sender1.Cancelling))) && ((Sender1.Home || Sender1.Sleeping) imply (O1.Silent && begun == 0)) && (O1.UnderWay imply begun >= 1)
/* J29 holds: so does a receiver. */
A[] ((W1_0.UnderWay || W1_1.UnderWay || X1.UnderWay || R1.UnderWay || Receiver1.Asked) imply O1.UnderWay) && (Receiver1.Coming imply (W1_0.UnderWay || W1_1.UnderWay)) && (W1_1.UnderWay imply D1_0.UnderWay) && (R1.UnderWay imply D1_1.UnderWay) && (woken[0] > 0 imply G1.UnderWay) && ((Receiver1.Here || Receiver1.Left) imply (woken[0] > 0 && A1.UnderWay))
/* J30 holds: a receiver wants, refuses, is ready, and answers an offer that is late. */
E<> Receiver1.Coming && has[0] == 1 && W1_1.UnderWay && X1.UnderWay && R1.Silent
/* J31 holds: a receiver may be killed when parts have come. */
E<> Receiver1.None && has[0] == 1 && X1.Silent && R1.Silent
/* J32 holds: or may forget them all. */
E<> Receiver1.None && has[0] == 0 && D1_1.UnderWay && X1.Silent && R1.Silent
/* J33 holds: an offer that is late may be wanted again. */
E<> Receiver1.Wanting && R1.UnderWay && has[0] == 0
/* J34 holds: of a process that was killed only its records and parts are left. */
A[] (Bus.Starting imply !(Receiver1.Asked || Receiver1.Wanting || Receiver1.Coming || Receiver1.Whole || Receiver1.Kept)) && (Support.Starting imply !(Sender1.Sleeping || Sender1.Deleted || Sender1.told))
/* J35 holds: all parts may be there, and no record. */
E<> Bus.Starting && has[0] == PARTS && Receiver1.None && R1.Silent
/* J36 holds: parts of which nothing is recorded may be left, or be lost. */
E<> Bus.Starting && has[0] == 0 && W1_1.UnderWay && X1.Silent && R1.Silent
/* J38 holds: only who offers has parts to send. */
A[] Sender1.Offered || Sender1.next == PARTS
