/* H1 holds: what the board deletes, and acknowledges, was handed on. */
A[] (taken >= 1 imply first > 0) && (taken == 2 imply second > 0)
/* H2 holds: each run of a host gets a message at most once. */
A[] first <= 1 + deaths && second <= 1 + deaths && (Agent.has_first imply first > 0) && (Agent.has_second imply second > 0)
/* H3 holds: a message is handed on again by each run that begins before its board knows that it was taken. */
E<> first == 3 && second == 3
/* H4 holds: messages are handed on in their order. */
A[] second > 0 imply first > 0
/* H5 holds: nothing is handed on that has not come. */
A[] (first > 0 imply come >= 1) && (second > 0 imply come == 2) && taken <= come
/* H6 holds: what was told to be taken is not told again. */
A[] had <= taken && (Agent.Handing imply (had < 1 || told <= taken))
/* H7 holds: nothing is stuck. */
A[] not deadlock
/* H8 holds: a message that has come can always still be taken, however often the host has died. */
E<> deaths == DEATHS && taken == 2
/* H9 holds: a reply leaves out what the board knows to be taken. */
A[] Agent.Handing imply (had == taken && shown >= had)
/* H10 holds: a host tells only what this run has handed on, or what was left out. */
A[] (told >= 1 imply (Agent.has_first || taken >= 1)) && (told == 2 imply (Agent.has_second || taken == 2))
/* H11 holds: a run begins with nothing. */
A[] Agent.Dead imply (!Agent.has_first && !Agent.has_second && told == 0)
/* H12 holds: what the board knows to be taken is not handed on again. */
A[] (Agent.First imply (taken < 1 && come >= 1 && !Agent.has_first)) && (Agent.Second imply (taken < 2 && come == 2 && !Agent.has_second))
/* H13 holds: a host may die before anything has come. */
E<> Agent.Dead && come == 0
/* H14 holds: or when it has handed on a part. */
E<> Agent.Dead && first == 1 && second == 0 && come == 2 && taken == 0
/* H15 holds: a poll may be lost. */
E<> Station.Waiting && Agent.Asking && told == 1 && taken == 0
/* H16 holds: all can be taken by a host that has died between. */
E<> deaths == DEATHS && first == 1 && second == 1 && taken == 2
/* H17 holds: a board replies only to a host that asks. */
A[] Station.Replying imply !(Agent.Handing || Agent.First || Agent.Second)
/* H18 holds: a reply may be lost. */
E<> Agent.Idle && told == 1 && taken == 1 && had == 0
/* H19 holds: then, too, a host may die, though it has died before. */
E<> Agent.Dead && taken == 1 && had == 0 && deaths == 2
/* H20 holds: or again while it hands on. */
E<> Agent.Dead && first == 2 && second == 0 && shown == 2 && taken == 0 && deaths == 2
