// World does all that others may do, with one carrier at a time, and no packet that comes is lost.

/* N1 holds: who waits for an answer takes the one that comes, in turn or not. */
A[] (Ear.Ack || Ear.Stale) imply (Police1.New || Police1.Part || Police1.OnAir || Police1.CutOff || (Ear.Ack ? Police1.Answered : Police1.Refused))
/* N2 holds: and goes on where it tells of fragments. */
A[] Ear.Fragments imply (Police1.Part || Police1.OnAir || Police1.CutOff || Police1.New || Police1.Ready && Police1.attempt == 0 || Police1.Pausing || Police1.PutOff || Police1.GivenUp)
/* N3 holds: it gives up only after all its attempts. */
A[] Police1.GivenUp imply Police1.attempt == MAX_ATTEMPTS
/* N4 holds: a message has its board's turn from when it contends until it has ended or its attempt has failed. */
A[] (turn[POLICE] == 1) == (Police1.Contending || Police1.Deferred || Police1.Part || Police1.OnAir || Police1.Pausing || Police1.PutOff || Police1.Awaiting || Police1.Held || Police1.CutOff)
/* N5 holds: then the board knows that it has ended. */
A[] (ended[POLICE] == 1) == (Police1.Answered || Police1.GivenUp || Police1.Refused || Police1.Over) && active == (ended[POLICE] == 0 && !Police1.New ? 1 : 0)
/* N6 holds: the message has the transmitter from each packet's begin to its end, and what is cut off ends at once. */
A[] ((Police1.Part || Police1.OnAir || Police1.CutOff) imply (sending[POLICE] && !World.mine && onAir > 0)) && (sending[POLICE] imply (World.mine || World.Begins || World.Ends || Police1.Part || Police1.OnAir || Police1.CutOff)) && (Police1.CutOff imply collided)
/* N7 holds: what it has on the air is a fragment that asks, or one that does not. */
A[] ((Police1.OnAir || Police1.Part) && !collided && World.There && kind > 0) imply (kind == (Police1.Part ? PART : DATA) && to == SUPPORT && from == POLICE && nonce == 1 && genuine)
/* N8 holds: patience runs as long as the answer is awaited. */
A[] (Police1.left > 0) == (Police1.Awaiting || Police1.Held)
/* N9 holds: who waits for the air knows whether a carrier is there. */
A[] ((Police1.Contending || Police1.Pausing || Police1.Awaiting) imply !busy) && ((Police1.Deferred || Police1.PutOff || Police1.Held) imply busy)
/* N10 holds: an attempt counts from its first packet that asks. */
A[] (Police1.OnAir || Police1.Awaiting || Police1.Held) imply Police1.attempt > 0
/* N11 holds: an answer that tells of something new lets the message begin its attempts anew. */
E<> Police1.Pausing && Police1.attempt == 0 && Police1.span > LEAST_WINDOW
/* N12 holds: an answer that does not leaves it those that are left. */
E<> Ear.Fragments && Police1.Pausing && Police1.attempt == 1 && Police1.span == LEAST_WINDOW && !Ear.answered
/* N13 holds: also where it has heard that answer while it waited for its turn. */
E<> Police1.Ready && Police1.attempt == 0 && Police1.span > LEAST_WINDOW
/* N14 holds: what its board was about when it was reset is over. */
A[] Ear.SenderCut imply (Police1.Over || Police1.CutOff)
/* N15 holds: the window doubles with each attempt that has failed, up to the widest. */
A[] (!Ear.answered && (Police1.Contending || Police1.Deferred)) imply Police1.span == (Police1.attempt == 0 ? LEAST_WINDOW : LAST_WINDOW)
/* N16 holds: nothing is ever stuck. */
A[] not deadlock
/* N17 holds: a message that contends, or goes on after an answer, has attempts left. */
A[] (Police1.Contending || Police1.Deferred || Police1.Pausing || Police1.PutOff) imply Police1.attempt < MAX_ATTEMPTS
/* N18 holds: World has no more carriers on the air than it may. */
A[] !World.Ends imply onAir <= CARRIERS + (sending[POLICE] ? 1 : 0)
/* N19 holds: World has the board's turn for other messages. */
E<> World.crowded && turn[POLICE] == 2 && World.mine && Police1.Ready
/* N21 holds: it sends answers of the board, too. */
E<> World.mine && turn[POLICE] == 1 && Police1.Contending
/* N22 holds: an acknowledgement can come. */
E<> Ear.Ack && Police1.Answered && Police1.attempt == 1
/* N23 holds: and a refusal. */
E<> Ear.Stale && Police1.Refused && Police1.attempt == 1
/* N24 holds: and an answer that tells of fragments. */
E<> Ear.Fragments && Police1.Pausing
/* N25 holds: a packet may be cut off. */
E<> Ear.SenderCut && Police1.CutOff
/* N26 holds: without an answer none is taken, and nothing is sent but whole attempts, each after the patience for the last. */
A[] (Ear.There && !Ear.answered) imply (!Police1.Answered && !Police1.Refused && ((Police1.Part || Police1.Pausing || Police1.PutOff) imply (Police1.attempt == 0) == (Police1.span == LEAST_WINDOW)))
/* N27 holds: an attempt may begin with a fragment that asks for nothing. */
E<> Police1.Part && Police1.attempt == 0 && !Ear.answered
/* N28 holds: after an answer an attempt may go on without a new wait. */
E<> Police1.OnAir && Police1.attempt == 2 && Police1.span == LEAST_WINDOW
/* N29 holds: such a fragment says so. */
E<> Police1.Part && kind == PART && Police1.attempt == 0 && !Ear.answered
/* N30 holds: also where a carrier is there. */
E<> Ear.Fragments && Police1.PutOff && Police1.attempt == 1 && Police1.span == LEAST_WINDOW && !Ear.answered
/* N31 holds: where it does, the message begins anew while its answer is awaited. */
E<> Ear.Fragments && Police1.Pausing && Police1.attempt == 0 && Police1.span == LEAST_WINDOW && Ear.asked && !Ear.answered
/* N32 holds: also where a carrier is there. */
E<> Ear.Fragments && Police1.PutOff && Police1.attempt == 0 && Police1.span == LEAST_WINDOW && Ear.asked && !Ear.answered
/* N33 holds: an answer to its last attempt that tells of nothing new ends it. */
E<> Ear.Fragments && Police1.GivenUp && !busy && !Ear.answered
/* N34 holds: also where a carrier is there. */
E<> Ear.Fragments && Police1.GivenUp && busy && !Ear.answered
/* N35 holds: it waits for a quiet slot before each packet. */
A[] (Early.Before && !collided) imply !(Police1.Part || Police1.OnAir)
/* N36 holds: and may send then a fragment that asks for nothing. */
E<> Early.Just && !collided && Police1.Part && kind == PART
/* N37 holds: or one that asks. */
E<> Early.Just && !collided && Police1.OnAir && kind == DATA
/* N38 holds: what is on the air alone is still being sent. */
A[] (Air.Busy && !collided && from == POLICE) imply sending[POLICE]
/* N39 holds: once a copy was heard, an attempt waits for a relay. */
E<> Ear.Copy && !Ear.copied && Police1.Awaiting && Police1.left == RELAY_PATIENCE && Police1.attempt == 1 && Police1.span == LEAST_WINDOW
/* N40 holds: also where a carrier is there. */
E<> Ear.Copy && !Ear.copied && Police1.Held && Police1.left == RELAY_PATIENCE && Police1.attempt == 1 && Police1.span == LEAST_WINDOW
/* N41 holds: and where it contends already for the next one. */
E<> Ear.Copy && !Ear.copied && Police1.Awaiting && Police1.left == RELAY_PATIENCE && Police1.attempt == 1 && Police1.span == LAST_WINDOW && !Ear.answered
/* N42 holds: likewise. */
E<> Ear.Copy && !Ear.copied && Police1.Held && busy && Police1.left == RELAY_PATIENCE && Police1.attempt == 1 && Police1.span == LAST_WINDOW && !Ear.answered
/* N43 holds: later attempts of what is in fragments wait no longer. */
E<> Police1.Held && Police1.left == PATIENCE && Police1.attempt == LATE_ATTEMPT + 1 && !Ear.answered
/* N44 holds: nothing has patience but an attempt that awaits its answer. */
A[] Police1.left == 0 || Police1.Awaiting || Police1.Held
