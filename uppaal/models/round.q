/* W12 holds: an agent that goes there and back is awake in the end, here or there. */
Sender1.Offered --> awake[SUPPORT] + awake[BUS] == 1
/* W13 holds: also when it comes back. */
Sender2.Offered --> awake[SUPPORT] + awake[BUS] == 1
/* W14 holds: senders do not wait for ever. */
Sender1.Gone --> Sender1.Away || Sender1.Over
/* W15 holds: likewise. */
Sender2.Gone --> Sender2.Away
/* W16 holds: nor do receivers. */
Receiver2.Ready --> Receiver2.Here || Receiver2.None
/* W17 holds: in the end exactly one is awake, where the records say so, and nobody waits. */
A[] deadlock imply (awake[SUPPORT] + awake[BUS] == 1 && !Sender1.Gone && !Sender2.Gone && !Receiver1.Ready && !Receiver2.Ready && (Receiver2.Here imply (awake[SUPPORT] == 1 && Receiver1.Left)))
/* W18 holds: it may be back in the end, though all was lost and killed that could be. */
E<> deadlock && Receiver2.Here && losses == 1 && kills == 1
