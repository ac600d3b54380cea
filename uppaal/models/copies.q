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
A[] !Watch.Early && (Home.Failed imply Watch.failed)
/* A7 holds: a relay that has heard the acknowledgement sends no further copy. */
A[] (Air.Carries && kind == DATA && by == ONE) imply !One.answered
/* A8 holds: it carries only acknowledgements that it has heard. */
A[] (Air.Carries && kind == ACK && by == ONE) imply One.answered
/* A9 holds: it knows of an acknowledgement until the packet begins anew. */
A[] (One.Answered || One.Asked || One.Carrying || One.Kept) == One.answered
/* A10 holds: what it sends has its hops, and is as it came. */
A[] (Air.Carries && by == ONE) imply (hops == One.own && genuine == (kind == DATA || One.right))
/* A11 holds: the message may be delivered by the relay alone. */
E<> Home.Delivered && One.answers == 1 && One.spent == 0 && Home.attempt <= 2
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
E<> Home.Awaiting && Home.rounds == ROUNDS_WITH_RELAY && Home.attempt <= 2
/* A81 holds: each packet is forgotten when it is over, and what each has made of it. */
A[] (Air.Quiet ? kind == 0 && hops == 0 && by == 0 && !genuine : kind != 0) && (Air.Over || rule[SENDER] == 0 && rule[ONE] == 0 && rule[TWO] == 0 && rule[RECEIVER] == 0 && rule[ATTACKER] == 0)
/* A82 holds: a relay with an empty place knows nothing of the packet. */
A[] One.Empty imply (!One.right && !One.copied && !One.repeated && !One.handed && !One.reserved && !One.passed && One.own == 0)
/* A83 holds: a relay takes what is new. In the greatest doubt, or away, it is in reserve (rule 1). */
A[] rule[ONE] == TAKES imply (kind == DATA && genuine && by != ONE && One.own == (hops == 3 ? 0 : hops + 1) && One.repeated == (One.doubt > NO_DOUBT) && !One.handed && One.answers == 0 && !One.copied && (One.doubt == MOST || One.away ? One.Reserve : One.Waiting))
/* A84 holds: one in reserve steps in where the packet comes from upstream again (rule 1). */
A[] rule[ONE] == STEPS_IN imply (kind == DATA && genuine && by != ONE && One.own == (hops == 3 ? 0 : hops + 1) && One.repeated && One.reserved && !One.handed && One.answers == 0 && One.Waiting)
/* A85 holds: it sends no further copy where the packet comes from downstream: it was handed on (rule 2). */
A[] rule[ONE] == GONE_ON imply (kind == DATA && genuine && by != ONE && hops != One.own && One.own != (hops == 3 ? 0 : hops + 1) && One.handed && One.Known)
/* A86 holds: it sends no first copy where the packet comes from a peer (rule 2). */
A[] rule[ONE] == PEER imply (kind == DATA && genuine && by != ONE && hops == One.own && !One.copied && One.Known)
/* A87 holds: it notes, too, where the packet is handed on later (rule 2). */
A[] rule[ONE] == NOTED imply (kind == DATA && genuine && by != ONE && hops != One.own && One.own != (hops == 3 ? 0 : hops + 1) && One.handed && (One.Known || One.Reserve))
/* A88 holds: it copies again where the sender itself sends again (rule 4). */
A[] (rule[ONE] == STILL_ASKS || rule[ONE] == ASKS_AGAIN) imply (kind == DATA && genuine && by != ONE && hops == 0 && One.own == 1 && One.Waiting && (rule[ONE] == ASKS_AGAIN || One.copied))
/* A89 holds: it begins anew what comes late (rule 5). */
A[] rule[ONE] == ANEW imply (kind == DATA && genuine && by != ONE && One.own == (hops == 3 ? 0 : hops + 1) && One.repeated == (One.doubt > NO_DOUBT) && !One.handed && One.answers == 0 && !One.reserved && !One.away && (One.doubt == MOST ? One.Reserve : One.Waiting))
/* A90 holds: it keeps the first acknowledgement (rule 6). */
A[] One.Answered imply (Air.Over && kind == ACK && by != ONE && One.right == genuine && rule[ONE] != ASKED)
/* A91 holds: its doubt rises where it has copied nothing. */
A[] rule[ONE] == NEEDLESS imply (!One.copied && One.Kept && One.doubt > NO_DOUBT)
/* A92 holds: its doubt ends where its copy has soon brought the message on. It then carries an acknowledgement from its origin or from downstream (rule 6). */
A[] rule[ONE] == SOON imply (One.copied && (One.handed || hops == DIRECT) && (hops != One.own && One.own != (hops == 3 ? 0 : hops + 1) ? One.Carrying : One.Kept) && One.doubt == (One.reserved ? AFTER_RESERVE : NO_DOUBT))
/* A93 holds: its doubt is greatest where its copy came too late. It then leaves the acknowledgement to others. */
A[] rule[ONE] == TOO_LATE imply (One.copied && hops == DIRECT && One.doubt == MOST && One.Kept)
/* A94 holds: where another relay has brought the acknowledgement, it carries it if that is downstream (rule 6). */
A[] rule[ONE] == ELSEWHERE imply (One.copied && hops != DIRECT && (hops != One.own && One.own != (hops == 3 ? 0 : hops + 1) ? One.Carrying : One.Kept))
/* A95 holds: an acknowledgement from upstream has gone on (rules 7 and 8). */
A[] (rule[ONE] == PASSED || rule[ONE] == PASSED_LATER) imply (kind == ACK && by != ONE && One.own == (hops == 3 ? 0 : hops + 1) && One.passed && One.Kept)
/* A96 holds: one from a peer is carried by that peer (rule 8). */
A[] rule[ONE] == CARRIED imply (kind == ACK && by != ONE && hops == One.own && One.Kept)
/* A97 holds: a packet that comes again, but not from downstream, asks for its acknowledgement (rule 9). */
A[] One.Asked imply (Air.Over && rule[ONE] == ASKED && kind == DATA && genuine && by != ONE && (hops == One.own || One.own == (hops == 3 ? 0 : hops + 1)))
/* A98 holds: the acknowledgement is then carried again (rule 9). */
A[] rule[ONE] == REPEATS imply (kind == DATA && genuine && by != ONE && One.answers < MOST_ANSWERS && One.Carrying)
/* A99 holds: after four copies of it the packet is forgotten (rule 9). */
A[] rule[ONE] == FORGETS imply (kind == DATA && genuine && by != ONE && One.answers == MOST_ANSWERS && One.Empty)
/* A100 holds: a copy is the last one where it was repeated, or handed on (rule 3). */
A[] (Air.Carries && kind == DATA && by == ONE) imply (One.copied && One.spent > 0 && (One.Waiting ? One.repeated && !One.handed : One.Known && (One.repeated || One.handed)))
/* A101 holds: a copy of an acknowledgement is the last one after two repeats, next to the sender, or where it has gone on (rule 7). */
A[] (Air.Carries && kind == ACK && by == ONE) imply (One.Carrying ? One.answers <= ANSWER_REPEATS && One.own != 1 && !One.passed : One.Kept && (One.answers > ANSWER_REPEATS || One.own == 1 || One.passed))
/* A102 holds: a sender sends the message as its own, and waits. */
A[] (Air.Carries && by == SENDER) imply (kind == DATA && hops == 0 && genuine && Home.Awaiting && Home.rounds == (Home.attempt > LATE_ATTEMPT ? LATE_ROUNDS : 0))
/* A103 holds: a receiver sends an acknowledgement of what the host has. */
A[] (Air.Carries && by == RECEIVER) imply (kind == ACK && hops == DIRECT && genuine && given == 1 && Away.Listening)
/* A104 holds: a sender that hears a copy waits for longer. */
A[] (rule[SENDER] == COPIED || rule[SENDER] == COPIED_LATE) imply (kind == DATA && by != SENDER && Home.attempt > 0 && (Home.Copied ? Watch.failed == (rule[SENDER] == COPIED_LATE) : Home.Awaiting && Home.rounds == ROUNDS_WITH_RELAY))
/* A105 holds: a sender that hears a genuine acknowledgement is done. */
A[] (rule[SENDER] == DELIVERED || rule[SENDER] == DELIVERED_LATE) imply (kind == ACK && genuine && Home.Delivered && Home.rounds == 0 && Watch.failed == (rule[SENDER] == DELIVERED_LATE))
/* A106 holds: a receiver owes an acknowledgement of all that is genuine. */
A[] (rule[RECEIVER] == GETS || rule[RECEIVER] == GETS_AGAIN) imply (kind == DATA && genuine && Away.known && Away.Due && !(rule[RECEIVER] == GETS && One.right))
/* A107 holds: it knows what the host has. */
A[] Away.known == (given > 0)
/* A108 holds: what a receiver owes is sent. */
Away.Due --> Away.Listening
/* A109 holds: what a relay owes is sent, or is no longer due. */
(One.Waiting || One.Carrying) --> (!One.Waiting && !One.Carrying)
/* A110 holds: a receiver gets the message. */
E<> rule[RECEIVER] == GETS
/* A111 holds: a repeat is acknowledged, too. */
E<> rule[RECEIVER] == GETS_AGAIN
/* A112 holds: a copy may come while its sender waits. */
E<> rule[SENDER] == COPIED && by == ONE
