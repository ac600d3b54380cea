/* M1 holds: a host of the group gets each multicast at most once. */
A[] Support.given1 <= 1 && Support.given2 <= 1
/* M2 holds: it gets nothing that was not sent. */
A[] (Support.given1 > 0 imply Police.current >= 1) && (Support.given2 > 0 imply Police.current >= 2)
/* M3 holds: nobody outside the group gets any. */
A[] Hospital.given1 == 0 && Hospital.given2 == 0 && Hospital.waits1 == 0 && Hospital.waits2 == 0
/* M4 holds: nothing is accepted that is older than what the host has. */
A[] (Support.waits1 > 0 imply Support.taken < 1) && (Support.waits2 > 0 imply Support.taken < 2)
/* M5 holds: nothing is stuck before all messages have been sent. */
A[] deadlock imply (Police.Idle && Police.current == MESSAGES)
/* M6 holds: both can be received. */
E<> Support.given1 == 1 && Support.given2 == 1
