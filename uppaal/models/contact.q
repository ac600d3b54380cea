/* W1 holds: at no moment are two awake. */
A[] awake[SUPPORT] + awake[BUS] <= 1
/* W2 holds: an agent that sleeps to leave is awake in the end, here or there. */
Sender1.Sleeping --> awake[SUPPORT] + awake[BUS] == 1
/* W3 holds: also from each moment on. */
Sender1.Offered --> awake[SUPPORT] + awake[BUS] == 1
/* W4 holds: a sender learns how its move ends. */
Sender1.Offered --> Sender1.Over || Sender1.Away
/* W5 holds: what has gone is awake there in the end, and its sender knows. */
Sender1.Gone --> Sender1.Away && awake[BUS] == 1
/* W6 holds: a receiver that is ready does not wait for ever. */
Receiver1.Ready --> Receiver1.Here || Receiver1.None
/* W7 holds: nor does one to which parts come. */
Receiver1.Coming --> !Receiver1.Coming
/* W8 holds: in the end exactly one is awake, and nobody waits. */
A[] deadlock imply ((Sender1.Home || Sender1.Over || Sender1.Away) && (Receiver1.None || Receiver1.Here) && awake[SUPPORT] + awake[BUS] == 1 && underWay[0] == 0)
/* W9 holds: it may be there in the end, though all was lost and killed that could be. */
E<> deadlock && awake[BUS] == 1 && losses == 2 && kills == 1 && copies == 1
/* W10 holds: or here. */
E<> deadlock && awake[SUPPORT] == 1 && Sender1.Over && has[0] == PARTS
/* W11 holds: patience lasts as long as it should. */
E<> Sender1.tries == 5
/* W19 holds: an agent of which a part is there goes on from there. */
E<> kills == 0 && copies == 0 && Sender1.grown && Receiver1.Here
/* W20 holds: what is new there prolongs the patience. */
E<> Sender1.grown && Sender1.tries == 0 && W1_1.Silent && Sender1.next == 1
/* W21 holds: a part may be wrong; then it is forgotten. */
E<> kills == 0 && Sender1.grown && X1.UnderWay && has[0] == 0
/* W22 holds: parts follow each other without being asked for. */
E<> kills == 0 && Sender1.tries == 2 && !Sender1.grown && Receiver1.Here
/* W23 holds: a message may be lost. */
E<> losses == 1 && O1.Silent && Sender1.tries == 1
/* W24 holds: a sender that is started again has all its patience. */
A[] (Support.Starting && Sender1.Offered) imply (Sender1.tries == 0 && !Sender1.grown && Sender1.next == PARTS)
/* W25 holds: who is refused does not wait on. */
A[] (losses == 0 && copies == 0 && kills == 0 && underWay[0] == 0 && Sender1.Offered && Sender1.tries == 1 && !Sender1.grown) imply !Receiver1.None
/* W26 holds: a sender that offers says one thing at a time. */
A[] (O1.UnderWay ? 1 : 0) + (D1_0.UnderWay ? 1 : 0) + (D1_1.UnderWay ? 1 : 0) <= 1
/* W27 holds: patience may last for so many offers. */
E<> kills == 0 && Sender1.tries == TRIES && Receiver1.Asked
/* W28 holds: nobody forgets a move while what he wants is under way. */
A[] (kills == 0 && (W1_0.UnderWay || W1_1.UnderWay)) imply !Receiver1.None
/* W29 holds: nobody wants what he has. */
A[] (kills == 0 && W1_0.UnderWay) imply has[0] == 0
/* W30 holds: a part that comes twice is answered with what is wanted. */
E<> kills == 0 && losses == 0 && Sender1.tries == 2 && !Sender1.grown && W1_1.UnderWay
/* W31 holds: a receiver that is killed in the midst of its parts may keep what has come. */
E<> Bus.Starting && losses == 0 && copies == 0 && underWay[0] == 0 && Sender1.next == 1 && has[0] == 1
/* W32 holds: or lose it. */
E<> Bus.Starting && losses == 0 && copies == 0 && underWay[0] == 0 && Sender1.next == 1 && has[0] == 0
