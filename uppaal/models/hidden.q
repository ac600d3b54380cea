/* HB1 holds: each host gets a message at most once. */
A[] given[0] <= 1 && given[1] <= 1
/* HB2 holds: what is reported delivered has come. */
A[] (One.Delivered imply given[0] == 1) && (Other.Delivered imply given[1] == 1)
/* HB3 holds: each transmission ends. */
A<> (One.Delivered || One.GivenUp) && (Other.Delivered || Other.GivenUp)
/* HB4 fails: one is delivered in the end, though nothing is lost but to the other one. */
A<> One.Delivered
/* HB5 holds: neither may be delivered. */
E<> One.GivenUp && Other.GivenUp && given[0] == 0 && given[1] == 0
/* HB6 holds: both may be. */
E<> One.Delivered && Other.Delivered
/* HB7 holds: each begins into the other one's packets, though it listens first. */
E<> FromOne.Lost && FromOther.Lost
/* HB8 holds: an answer settles what it is for. */
A[] Between.Sending imply (Between.to == 0 imply !owes[0]) && (Between.to == 1 imply !owes[1])
/* HB9 holds: an attempt may fail while its answer waits for the other one's packet. */
E<> One.Contending && owes[0] && Other.OnAir
/* HB10 holds: an answer that comes so late is taken. */
E<> One.Delivered && One.left == 0
/* HB11 holds: nothing is stuck before the end. */
A[] deadlock imply (One.Delivered || One.GivenUp) && (Other.Delivered || Other.GivenUp)
/* HB12 holds: what begins alone and ends alone comes, and is answered, each time. */
A[] See.Came imply given[0] == 1 && owes[0]
/* HB13 holds: what does not, is lost. */
A[] See.Missed imply given[0] == 0
/* HB14 holds: who sends waits for quiet air, and repeats or gives up after its whole patience. */
A[] !Pauses.Wrong
/* HB15 holds: it need not wait longer for quiet air, */
E<> Pauses.Just
/* HB16 holds: nor for an answer, */
E<> Pauses.Due && One.attempt == 2
/* HB17 holds: while its patience is short, */
E<> Pauses.Due && One.attempt == LATE_ATTEMPT + 1
/* HB18 holds: and while it is long. */
E<> Pauses.Due && One.attempt > LATE_ATTEMPT + 1
/* HB19 holds: an answer comes at once; if somebody has begun meanwhile, after a random wait. */
A[] !Answers.Wrong
/* HB20 holds: such a wait is short, */
E<> Answers.Least && Between.to == 0
/* HB21 holds: for the one as for the other, */
E<> Answers.Least && Between.to == 1
/* HB22 holds: or long. */
E<> Answers.Most && Between.to == 0
/* HB23 holds: so, too. */
E<> Answers.Most && Between.to == 1
/* HB24 holds: nobody waits for his turn while he hears an answer. */
A[] Between.Sending imply !(One.Contending || One.Awaiting || Other.Contending || Other.Awaiting)
/* HB25 holds: somebody may begin in an answer's first slot, in which nobody hears it. */
E<> Between.Sending && One.OnAir && Other.Held
/* HB26 holds: what is on the air is counted. */
A[] onAir == One.OnAir + Other.OnAir
/* HB27 holds: the one between hears what is sent. */
A[] (FromOne.Nothing imply !One.OnAir) && (One.OnAir imply !FromOne.Nothing)
/* HB28 holds: it answers what has come. */
A[] (owes[0] imply given[0] == 1) && (owes[1] imply given[1] == 1)
/* HB29 holds: all that it owes it sends. */
(One.Delivered || One.GivenUp) && (Other.Delivered || Other.GivenUp) --> !owes[0] && !owes[1] && !answering
/* HB30 holds: it may owe two answers. */
E<> owes[0] && owes[1]
/* HB31 holds: a message is given up after all its attempts. */
A[] One.GivenUp imply One.attempt == MAX_ATTEMPTS
/* HB32 holds: each attempt waits in a window twice as wide, up to the widest. */
A[] One.OnAir imply (One.attempt == 1 imply One.span == LEAST_WINDOW) && (One.attempt == 2 imply One.span == 2 * LEAST_WINDOW) && (One.attempt > 3 imply One.span == LAST_WINDOW)
/* HB33 holds: nothing comes while the one between sends. */
A[] (FromOne.Coming || FromOther.Coming) imply !(Between.Starting || Between.Sending)
/* HB34 holds: an answer may come while it is awaited. */
E<> One.Delivered && One.left > 0
/* HB35 holds: who gives up awaits nothing. */
A[] One.GivenUp imply One.left == 0
/* HB36 holds: the one is answered after the other. */
E<> Answers.Fresh && Between.to == 0 && Other.Delivered
