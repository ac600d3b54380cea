/* A1 holds: the host gets the message at most once. */
A[] given <= 1
/* A2 holds: it is reported delivered only if the host has it. */
A[] Home.Delivered imply given == 1
/* A3 holds: the message ends. */
A<> Home.Delivered || Home.GivenUp
/* A4 holds: nothing is stuck: where nothing is possible any more, the message has ended, and nobody has anything to send. */
A[] deadlock imply ((Home.Delivered || Home.GivenUp) && !Away.Due && !One.Waiting && !One.Carrying)
/* A5 holds: it is given up only after all attempts. */
A[] Home.GivenUp imply Home.attempt == MAX_ATTEMPTS
/* A6 holds: no attempt fails before the whole patience is over: 3 s once a copy was heard. */
A[] !Watch.Early
/* A7 holds: a relay that has heard the acknowledgement sends no further copy. */
A[] (Air.Carries && kind == DATA && by == ONE) imply !One.answered
/* A8 holds: it carries acknowledgements only of what it has copied. */
A[] (Air.Carries && kind == ACK && by == ONE) imply (One.answered && One.copied)
/* A9 holds: it knows of an acknowledgement until the packet begins anew. */
A[] (One.Answered || One.Carrying || One.Kept) == One.answered
/* A10 holds: what it sends has its hops, and is as it came. */
A[] (Air.Carries && by == ONE) imply (kind == DATA ? genuine && hops == One.own : hops == One.back && genuine == One.right)
/* A11 holds: the message may be delivered by the relay alone. */
E<> Home.Delivered && One.answers == 1 && One.spent == 0 && Home.attempt == 1
/* A12 holds: it may be given up though the host has it. */
E<> Home.GivenUp && given == 1
/* A13 holds: an acknowledgement ends what is due of the packet. */
A[] One.answered imply One.spent == 0
/* A14 holds: what has gone on is not sent once more of its own accord. */
A[] (One.Waiting && One.handed && !One.copied) imply One.own == 1
/* A15 holds: who hears no copy may still wait for four rounds, from the third attempt on. */
A[] (Home.Awaiting && !Watch.copied) imply Home.rounds <= (Home.attempt > LATE_ATTEMPT ? LATE_ROUNDS : 0)
/* A16 holds: an acknowledgement is carried four times at most. */
A[] One.answers <= MOST_ANSWERS
/* A17 holds: a copy may come back to its sender, who waits then. */
E<> Home.Awaiting && Home.rounds == ROUNDS_WITH_RELAY && Home.attempt == 1
