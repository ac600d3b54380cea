/* R1 holds: what a board seals all others accept whose keys are not deleted, whichever steps each has taken. */
A[] (Ear.Old imply ( \
        (leaving[0] || current[0] == OLD || second[0] == OLD) && \
        (leaving[1] || current[1] == OLD || second[1] == OLD) && \
        (leaving[2] || current[2] == OLD || second[2] == OLD))) && \
    (Ear.New imply ( \
        (leaving[0] || current[0] == NEW || second[0] == NEW) && \
        (leaving[1] || current[1] == NEW || second[1] == NEW) && \
        (leaving[2] || current[2] == NEW || second[2] == NEW)))
/* R2 holds: a board keeps the key of what it has under way, so that it can be acknowledged. */
A[] (underWay[0] == NOTHING || underWay[0] == current[0] || underWay[0] == second[0]) && \
    (underWay[1] == NOTHING || underWay[1] == current[1] || underWay[1] == second[1]) && \
    (underWay[2] == NOTHING || underWay[2] == current[2] || underWay[2] == second[2])
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
/* R9 holds: keys can be deleted before the renewal. */
E<> Police.Leaving && Police.known && !Police.accepts
/* R10 holds: and of a board that accepts the next key, before the host knows that. */
E<> Police.Leaving && !Police.known && current[0] == OLD
/* R11 holds: and of one that seals with it. */
E<> Police.Leaving && !Police.known && current[0] == NEW
/* R12 holds: what is sealed with either key can come where the other one is in use. */
E<> Ear.Old && current[1] == NEW && current[2] == NEW
/* R13 holds: likewise. */
E<> Ear.New && current[1] == OLD && current[2] == OLD
/* R14 holds: the host knows of no more boards than have taken the step. */
A[] accepting <= BOARDS && sealing <= accepting && (Police.accepts imply !Police.Begun) && (Police.seals imply (Police.Seals || Police.Finished || Police.Leaving || Police.Gone))
/* R15 holds: the key that seals is the old one until the board uses the next, and then that. */
A[] ((Police.Begun || Police.Accepts) imply current[0] == OLD) && ((Police.Seals || Police.Finished) imply current[0] == NEW) && (Police.Gone imply current[0] == NOTHING) && leaving[0] == (Police.Leaving || Police.Gone)
