/* A61 holds: a relay in reserve is silent as long as the packet comes once. */
A[] (Two.copied && !Two.late) imply Two.reserved
/* A62 holds: it brings on what comes again. */
E<> Home.Delivered && Two.reserved && Two.answers > 0
/* A63 holds: it sends that once, unless its sender asks again. */
A[] Two.spent <= Home.attempt
/* A64 holds: after that it stays behind the others. */
A[] (Two.answered && Two.reserved && Two.doubt != MOST) imply Two.doubt == AFTER_RESERVE
/* A65 holds: and may. */
E<> Two.answered && Two.reserved && Two.doubt == AFTER_RESERVE
