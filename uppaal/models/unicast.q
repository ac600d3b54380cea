// Properties of two unicasts of one board to another, in the scenes unicast and repeats.

/* D1 holds: the receiver's host gets each message at most once. */
A[] given[1] <= 1 && given[2] <= 1
/* D2 holds: it gets nothing that was not sent. */
A[] (given[1] > 0 imply Police1.attempt > 0) && (given[2] > 0 imply Police2.attempt > 0)
/* D3 holds: what is reported delivered, the host has got. */
A[] (Police1.Answered imply given[1] > 0) && (Police2.Answered imply given[2] > 0)
/* D4 holds: nothing is accepted that is older than what the host has. */
A[] (waiting[1] imply taken[SUPPORT] < 1) && (waiting[2] imply taken[SUPPORT] < 2)
/* D5 holds: nothing is stuck before all messages have ended. */
A[] deadlock imply (Police1.Over && Police2.Over && Answer1.Idle && Answer2.Idle)
/* D6 holds: both messages can be delivered. */
E<> Police1.Answered && Support2.Taken && Police2.Held
/* D7 holds: a message that is given up may have arrived. */
E<> Police1.GivenUp && given[1] == 1
/* D8 holds: a message is given up only after all its attempts. */
A[] (Police1.GivenUp imply Police1.attempt == MAX_ATTEMPTS) && (Police2.GivenUp imply Police2.attempt == MAX_ATTEMPTS)
/* D9 holds: nobody begins to send while a carrier is heard. */
A[] !late
/* D10 holds: messages to one device are under way one after the other. */
A[] (Police1.New || Police1.Ready || Police1.Contending || Police1.Deferred || Police1.OnAir || Police1.Awaiting || Police1.Held) imply Police2.New
/* D11 holds: a board's transmitter has one packet at a time, and is free as soon as that is over. */
A[] sending[POLICE] == (Police1.OnAir || Police2.OnAir) && sending[SUPPORT] == (Answer1.OnAir || Answer2.OnAir) && !(Answer1.OnAir && Answer2.OnAir) && !(Police1.OnAir && Police2.OnAir)
/* D12 holds: only what the host has is acknowledged. */
A[] (Answer1.OnAir imply given[1] > 0) && (Answer2.OnAir imply given[2] > 0)
/* D13 holds: an attempt has failed only after the whole patience, which runs as long as the answer is awaited. */
A[] (Police1.left > 0) == (Police1.Awaiting || Police1.Held) && (Police2.left > 0) == (Police2.Awaiting || Police2.Held)
/* D14 holds: a repeat of what the host has is acknowledged again, and a damaged one twice. */
E<> Answer1.OnAir && Police1.attempt == 2 && given[1] == 1 && again[1]
/* D15 holds: a message has its board's turn from when it contends until it has ended or its attempt has failed. */
A[] (turn[POLICE] == 1) == (Police1.Contending || Police1.Deferred || Police1.OnAir || Police1.Awaiting || Police1.Held) && (turn[POLICE] == 2) == (Police2.Contending || Police2.Deferred || Police2.OnAir || Police2.Awaiting || Police2.Held)
/* D16 holds: the board knows which message has ended last. */
A[] (ended[POLICE] == 0) == (Police1.New || Police1.Ready || Police1.Contending || Police1.Deferred || Police1.OnAir || Police1.Awaiting || Police1.Held) && (ended[POLICE] == 2) == (Police2.Answered || Police2.GivenUp || Police2.Over)
/* D17 holds: and how many are under way. */
A[] active == (ended[POLICE] == 0 && !Police1.New || ended[POLICE] == 1 && !Police2.New ? 1 : 0)
/* D18 holds: the other board knows which message its host has been told of, and which it has taken. */
A[] waiting[1] == (Support1.Queued || Support1.Handed || Support1.Taking) && waiting[2] == (Support2.Queued || Support2.Handed || Support2.Taking) && unread[1] == Support1.Queued && unread[2] == Support2.Queued
/* D19 holds: the last that the host has taken is the last that the board refuses. */
A[] taken[SUPPORT] == (Support2.Taken ? 2 : Support1.Taken ? 1 : 0)
/* D20 holds: the host has exactly those that were handed to it. */
A[] (given[1] == 1) == (Support1.Handed || Support1.Taking || Support1.Taken) && (given[2] == 1) == (Support2.Handed || Support2.Taking || Support2.Taken)
/* D21 holds: it takes the second message only after the first, or without it. */
A[] (Support2.Taking || Support2.Taken) imply !waiting[1]
/* D22 holds: a message on the air is what its sender has begun to send. */
A[] ((Police1.OnAir || Police2.OnAir) && !collided && !Air.Heard) imply (kind == DATA && to == SUPPORT && from == POLICE && genuine && nonce == (Police1.OnAir ? 1 : 2))
/* D23 holds: and so is an answer. */
A[] ((Answer1.OnAir || Answer2.OnAir) && !collided) imply (kind == ACK && to == POLICE && from == SUPPORT && genuine && nonce == (Answer1.OnAir ? 1 : 2))
/* D24 holds: each attempt after the first doubles the window, up to the widest. */
A[] Police1.Contending imply (Police1.span == (Police1.attempt == 0 ? LEAST_WINDOW : Police1.attempt == 1 ? 2 * LEAST_WINDOW : Police1.span) && (Police1.attempt > 2 imply Police1.span == LAST_WINDOW))
/* D25 holds: who waits for its turn, or for the other board, knows whether a carrier is there. */
A[] ((Police1.Contending || Police1.Awaiting || Answer1.Due || Answer1.PutOff) imply !busy) && ((Police1.Deferred || Police1.Held) imply busy)
/* D26 holds: nothing that was on the air is left when it is quiet. */
A[] Air.Quiet imply (kind == 0 && to == NOBODY && from == NOBODY && nonce == 0 && !genuine)
/* D27 holds: nothing is received before its packet has ended. */
A[] ((Police1.OnAir && Police1.attempt == 1) imply Support1.Listening) && ((Police2.OnAir && Police2.attempt == 1) imply Support2.Listening)
/* D28 holds: nothing is acknowledged that is older than the last that the host has. */
A[] Answer1.OnAir imply !Police2.Answered
/* D29 holds: what is owed is an acknowledgement, and twice only what is owed. */
A[] (owed[1] == 0 || owed[1] == ACK) && (owed[2] == 0 || owed[2] == ACK) && (again[1] imply owed[1] == ACK) && (again[2] imply owed[2] == ACK)
/* D30 holds: an answer is under way only where one is owed. */
A[] (!Answer1.Idle imply owed[1] > 0) && (!Answer2.Idle imply owed[2] > 0)
/* D31 holds: who contends has attempts left. */
A[] ((Police1.Contending || Police1.Deferred) imply Police1.attempt < MAX_ATTEMPTS) && ((Police2.Contending || Police2.Deferred) imply Police2.attempt < MAX_ATTEMPTS)
/* D32 holds: a message may be lost each time that it is sent. */
E<> Police1.GivenUp && Support1.Listening && Police2.New
/* D33 holds: a repeat may be lost. */
E<> Support1.Taken && taken[SUPPORT] == 1 && owed[1] == 0 && Air.Freeing && !collided && kind == DATA && nonce == 1 && genuine
/* D34 holds: so may an acknowledgement. */
E<> Police1.Held && Air.Freeing && !collided && kind == ACK && nonce == 1 && genuine
/* D35 holds: also where its message contends anew. */
E<> Police1.Deferred && Air.Freeing && !collided && kind == ACK && nonce == 1 && genuine
/* D36 holds: a repeat may be lost where an answer waits. */
E<> Answer1.Pending && Air.Freeing && !collided && kind == DATA && nonce == 1 && genuine
