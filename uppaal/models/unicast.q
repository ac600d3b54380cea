/* D1 holds: the receiver's host gets each message at most once. */
A[] Support.given1 <= 1 && Support.given2 <= 1
/* D2 holds: it gets nothing that was not sent. */
A[] (Support.given1 > 0 imply Police.current >= 1) && (Support.given2 > 0 imply Police.current >= 2)
/* D3 holds: what is reported delivered, the host has got. */
A[] (Police.told1 imply Support.given1 > 0) && (Police.told2 imply Support.given2 > 0)
/* D4 holds: nothing is accepted that is older than what the host has. */
A[] (Support.waits1 > 0 imply Support.taken < 1) && (Support.waits2 > 0 imply Support.taken < 2)
/* D5 holds: nothing is stuck before all messages have ended. */
A[] deadlock imply (Police.Idle && Police.current == MESSAGES)
/* D6 holds: both messages can be delivered. */
E<> Police.told1 && Police.told2
/* D7 holds: a message that is reported undelivered may have arrived. */
E<> Police.current == 2 && !Police.told1 && Support.given1 == 1
