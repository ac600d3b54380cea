/* A61 holds: a relay in reserve is silent as long as the packet comes once. */
A[] (Air.Carries && kind == DATA && by == TWO) imply Two.reserved
/* A62 holds: it brings on what comes again. */
E<> Home.Delivered && Two.reserved && Two.answers > 0
/* A63 holds: it sends that once, unless its sender asks again. */
A[] Two.spent <= Home.attempt
/* A64 holds: after that it stays behind the others. */
A[] (Two.answered && Two.reserved && Two.doubt != MOST) imply Two.doubt == AFTER_RESERVE
/* A65 holds: and may. */
E<> Two.answered && Two.reserved && Two.doubt == AFTER_RESERVE
/* A211 holds: A83 for the one in reserve. */
A[] rule[TWO] == TAKES imply (kind == DATA && genuine && by != TWO && Two.own == (hops == 3 ? 0 : hops + 1) && Two.repeated == (Two.doubt > NO_DOUBT) && !Two.handed && Two.answers == 0 && !Two.copied && Two.Reserve)
/* A212 holds: A84 for it. */
A[] rule[TWO] == STEPS_IN imply (kind == DATA && genuine && by != TWO && Two.own == (hops == 3 ? 0 : hops + 1) && Two.repeated && Two.reserved && !Two.handed && Two.answers == 0 && Two.Waiting)
/* A213 holds: A90 for it. */
A[] Two.Answered imply (Air.Over && kind == ACK && by != TWO && Two.right == genuine && Two.answered)
/* A214 holds: it stays in reserve where it was not needed. */
A[] rule[TWO] == NEEDLESS imply (!Two.copied && Two.Kept && Two.doubt == MOST)
/* A215 holds: it takes what the sender sends. */
E<> rule[TWO] == TAKES && by == SENDER
/* A216 holds: it takes what the other relay sends. */
E<> rule[TWO] == TAKES && by == ONE
/* A217 holds: it steps in where the sender sends again. */
E<> rule[TWO] == STEPS_IN && by == SENDER
/* A218 holds: it steps in where the other relay does. */
E<> rule[TWO] == STEPS_IN && by == ONE
/* A219 holds: in reserve it hears the acknowledgement by the receiver. */
E<> rule[TWO] == RELIEVED && by == RECEIVER
/* A220 holds: it hears it by the other relay, too. */
E<> rule[TWO] == RELIEVED && by == ONE
/* A221 holds: in reserve it hears that the packet was handed on. */
E<> rule[TWO] == NOTED && Two.Reserve
/* A224 holds: A87 for it. */
A[] rule[TWO] == NOTED imply (kind == DATA && genuine && by != TWO && hops != Two.own && Two.own != (hops == 3 ? 0 : hops + 1) && Two.handed && (Two.Known || Two.Reserve))
/* A222 holds: A89 for the one in reserve. */
A[] rule[TWO] == ANEW imply (kind == DATA && genuine && by != TWO && Two.own == (hops == 3 ? 0 : hops + 1) && !Two.reserved && !Two.away && (Two.doubt == MOST ? Two.Reserve : Two.Waiting))
/* A223 holds: an acknowledgement may be lost there. */
E<> Air.Over && Two.Reserve && rule[TWO] == 0 && by == RECEIVER
