/* A31 holds: two relays send two copies at most each for each attempt, whatever they hear of each other: no loop, no storm. */
A[] One.spent <= 2 * Home.attempt && Two.spent <= 2 * Home.attempt
/* A32 holds: one that has brought messages on may send so many. */
E<> One.spent == 2 * MAX_ATTEMPTS
/* A33 holds: one in doubt sends fewer. */
A[] Two.spent < 2 * MAX_ATTEMPTS
/* A34 holds: A7 for the other one. */
A[] (Air.Carries && kind == DATA && by == TWO) imply !Two.answered
/* A35 holds: A8 for the other one. */
A[] (Air.Carries && kind == ACK && by == TWO) imply (Two.answered && Two.copied)
/* A36 holds: who hears the other one's copy first keeps silent. */
E<> One.copied && Two.Known && !Two.copied && !Two.handed
/* A37 holds: a line of two: what the one has copied the other one copies. */
E<> Home.Delivered && One.own == 1 && Two.own == 2 && Two.copied && One.handed && One.answers > 0
/* A38 holds: where the acknowledgement goes on unheard, it is copied again, twice at most. */
E<> Two.answers == ANSWER_REPEATS + 1 && Two.own == 2
/* A39 holds: who hears it go on sends it no more of its own accord. */
A[] Two.Carrying imply (!Two.passed || Two.answers <= MOST_ANSWERS)
/* A40 holds: a relay whose copy has brought the message on has no doubt any more. */
E<> Two.answered && Two.doubt == NO_DOUBT
/* A41 holds: one whose copy came too late falls silent. */
E<> Two.answered && Two.doubt == MOST && Two.copied
/* A42 holds: one that was not needed doubts more. */
E<> Two.answered && Two.doubt == FIRST + 1 && !Two.copied
