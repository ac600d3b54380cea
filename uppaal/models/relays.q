/* A31 holds: two relays send two copies at most each for each attempt, whatever they hear of each other: no loop, no storm. */
A[] One.spent <= 2 * Home.attempt && Two.spent <= 2 * Home.attempt
/* A32 holds: one that has brought messages on may send so many. */
E<> One.spent == 2 * MAX_ATTEMPTS
/* A33 holds: one in doubt sends fewer. */
A[] Two.spent < 2 * MAX_ATTEMPTS
/* A34 holds: A7 for the other one. */
A[] (Air.Carries && kind == DATA && by == TWO) imply !Two.answered
/* A35 holds: A8 for the other one. */
A[] (Air.Carries && kind == ACK && by == TWO) imply Two.answered
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
/* A171 holds: a relay takes what is new: from the second relay. */
E<> rule[ONE] == TAKES && by == TWO
/* A172 holds: a relay takes what is new: from the first relay. */
E<> rule[TWO] == TAKES && by == ONE
/* A173 holds: where its copy is due, it hears that it was handed on: from the second relay. */
E<> rule[ONE] == GONE_ON && by == TWO
/* A174 holds: where its copy is due, it hears a peer: from the second relay. */
E<> rule[ONE] == PEER && by == TWO
/* A175 holds: where its copy is due, it hears a peer: from the first relay. */
E<> rule[TWO] == PEER && by == ONE
/* A176 holds: it hears later that it was handed on: from the second relay. */
E<> rule[ONE] == NOTED && by == TWO
/* A177 holds: it hears later that it was handed on: from the first relay. */
E<> rule[TWO] == NOTED && by == ONE
/* A178 holds: where its copy of an acknowledgement is due, it hears that this has gone on: from the second relay. */
E<> rule[ONE] == PASSED && by == TWO
/* A179 holds: where its copy of an acknowledgement is due, it hears that this has gone on: from the first relay. */
E<> rule[TWO] == PASSED && by == ONE
/* A180 holds: it hears later that an acknowledgement has gone on: from the second relay. */
E<> rule[ONE] == PASSED_LATER && by == TWO
/* A181 holds: it hears later that an acknowledgement has gone on: from the first relay. */
E<> rule[TWO] == PASSED_LATER && by == ONE
/* A182 holds: it leaves an acknowledgement to a peer: from the second relay. */
E<> rule[ONE] == CARRIED && by == TWO
/* A183 holds: it leaves an acknowledgement to a peer: from the first relay. */
E<> rule[TWO] == CARRIED && by == ONE
/* A184 holds: it carries an acknowledgement again: from the second relay. */
E<> rule[ONE] == REPEATS && by == TWO
/* A185 holds: it carries an acknowledgement again: from the first relay. */
E<> rule[TWO] == REPEATS && by == ONE
/* A186 holds: where its copy is due, it hears an acknowledgement: from the second relay. */
E<> rule[ONE] == ENDED && by == TWO
/* A187 holds: where its copy is due, it hears an acknowledgement: from the first relay. */
E<> rule[TWO] == ENDED && by == ONE
/* A188 holds: it hears an acknowledgement later: from the second relay. */
E<> rule[ONE] == ANSWERED && by == TWO
/* A189 holds: it hears an acknowledgement later: from the first relay. */
E<> rule[TWO] == ANSWERED && by == ONE
/* A190 holds: where its copy is due, it hears an acknowledgement: from the receiver. */
E<> rule[TWO] == ENDED && by == RECEIVER
/* A191 holds: it hears an acknowledgement later: from the receiver. */
E<> rule[TWO] == ANSWERED && by == RECEIVER
/* A192 holds: what was handed on may be acknowledged by another relay. */
E<> rule[ONE] == SOON && One.handed && hops != DIRECT
/* A193 holds: what nobody has heard to be handed on may be acknowledged by its receiver. */
E<> rule[ONE] == SOON && !One.handed && hops == DIRECT
/* A194 holds: a relay whose copy came too late leaves the acknowledgement to others. */
E<> rule[ONE] == TOO_LATE
/* A196 holds: a relay in doubt carries what comes from downstream. */
E<> rule[TWO] == ELSEWHERE && Two.Carrying && Two.doubt > NO_DOUBT
/* A197 holds: otherwise it does not. */
E<> rule[TWO] == ELSEWHERE && Two.Kept
/* A198 holds: nor does one without doubt. */
E<> rule[ONE] == ELSEWHERE && One.Kept && One.doubt == NO_DOUBT
/* A199 holds: an acknowledgement may be lost where a copy is due. */
E<> Air.Over && One.Waiting && rule[ONE] == 0 && by == RECEIVER
/* A200 holds: it may be lost where none is due. */
E<> Air.Over && One.Known && rule[ONE] == 0 && by == RECEIVER
/* A201 holds: a copy of it may be lost where an own one is due. */
E<> Air.Over && One.Carrying && rule[ONE] == 0 && kind == ACK && by == TWO && hops == One.own
/* A202 holds: it may be lost after that. */
E<> Air.Over && One.Kept && rule[ONE] == 0 && kind == ACK && by == TWO && !One.passed && One.own == (hops == 3 ? 0 : hops + 1)
/* A203 holds: nobody begins anew what comes back to it. */
A[] One.own < 3 && Two.own < 3
/* A205 holds: the second relay of a line carries an acknowledgement again. */
E<> rule[TWO] == REPEATS && Two.own == 2
