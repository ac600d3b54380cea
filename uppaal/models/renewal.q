/* R1 holds: what a board seals all others accept, whichever steps each has taken. */
A[] !refused
/* R2 holds: a board keeps the key of what it has under way, so that it can be acknowledged. */
A[] (Police.Finished imply Police.underWay != OLD) && (Support.Finished imply Support.underWay != OLD) && (Hospital.Finished imply Hospital.underWay != OLD)
/* R3 holds: messages under the old and the new key can be under way at once. */
E<> Police.underWay == NEW && Support.underWay == OLD
/* R4 holds: all can finish. */
E<> Police.Finished && Support.Finished && Hospital.Finished
