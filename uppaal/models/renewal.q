/* R1 holds: what a board seals all others accept whose keys are not deleted, whichever steps each has taken. */
A[] !refused
/* R2 holds: a board keeps the key of what it has under way, so that it can be acknowledged. */
A[] (underWay[0] == NOTHING || underWay[0] == current[0] || underWay[0] == second[0]) && (underWay[1] == NOTHING || underWay[1] == current[1] || underWay[1] == second[1]) && (underWay[2] == NOTHING || underWay[2] == current[2] || underWay[2] == second[2])
/* R3 holds: messages under the old and the new key can be under way at once. */
E<> underWay[0] == NEW && underWay[1] == OLD
/* R4 holds: all can finish. */
E<> Police.Finished && Support.Finished && Hospital.Finished
/* R5 holds: a board can go at any step, and the others finish without it. */
E<> Police.Gone && Support.Finished && Hospital.Finished
/* R6 holds: a board that has finished or is gone has no more of the old key. */
A[] (Police.Finished || Police.Gone) imply current[0] != OLD && second[0] != OLD && underWay[0] != OLD
/* R7 holds: a board that is about to go still has its current key, and no other. */
A[] Police.Leaving imply current[0] != NOTHING && second[0] == NOTHING
/* R8 fails: each board finishes or goes: one that takes up one message after the other may be BUSY for ever. */
Police.Begun --> Police.Finished || Police.Gone
