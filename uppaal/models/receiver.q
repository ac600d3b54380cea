// World does all that others may do, with one carrier at a time, and no packet that comes is lost.

/* V1 holds: a message waits from when it has come until its host has taken it. */
A[] waiting[1] == (Support1.Queued || Support1.Handed || Support1.Taking) && unread[1] == Support1.Queued
/* V2 holds: what the host has taken is known. */
A[] Support1.Taken imply taken[SUPPORT] >= 1
/* V3 holds: what is below the floor that a loss of power has left is not accepted. */
A[] Support1.Queued imply !Support1.lost
/* V4 holds: the host has what was handed to it. */
A[] (Support1.Handed || Support1.Taking || Support1.Taken) imply given[1] > 0
/* V5 holds: where its board has begun anew, it may get a message again. */
E<> given[1] == 2 && taken[SUPPORT] == 0
/* V6 holds: only what the host has is acknowledged, and only that twice. */
A[] (owed[1] == ACK || again[1]) imply given[1] > 0
/* V7 holds: only what is below the floor is stale. */
A[] owed[1] == STALE imply Support1.lost
/* V8 holds: an answer is under way only where one is owed, and it is one of three. */
A[] ((Answer1.Due || Answer1.Pending || Answer1.PutOff || Answer1.OnAir) imply owed[1] > 0) && (owed[1] == 0 || owed[1] == ACK || owed[1] == FRAGMENTS || owed[1] == STALE)
/* V9 holds: an answer has the transmitter from its begin to its end, and what is cut off ends at once. */
A[] ((Answer1.OnAir || Answer1.CutOff) imply (sending[SUPPORT] && !World.mine && onAir > 0)) && (sending[SUPPORT] imply (World.mine || World.Begins || World.Ends || Answer1.OnAir || Answer1.CutOff)) && (Answer1.CutOff imply collided)
/* V10 holds: it is for the message's sender. */
A[] (Answer1.OnAir && !collided && World.There && kind > 0) imply ((kind == ACK || kind == FRAGMENTS || kind == STALE) && to == POLICE && from == SUPPORT && nonce == 1 && genuine)
/* V11 holds: an answer that waits for the air knows whether a carrier is there. */
A[] ((Answer1.Due || Answer1.PutOff) imply !busy)
/* V12 holds: it may tell that the message is stale. */
E<> Answer1.OnAir && owed[1] == STALE
/* V13 holds: which fragments have come. */
E<> Answer1.OnAir && owed[1] == FRAGMENTS && Support1.Listening
/* V14 holds: also where the host has newer messages. */
E<> Answer1.OnAir && owed[1] == FRAGMENTS && Support1.Taken && taken[SUPPORT] == 2
/* V15 holds: that the host has it, again and twice. */
E<> Answer1.OnAir && owed[1] == ACK && again[1] && given[1] == 1
/* V16 holds: nothing is ever stuck. */
A[] not deadlock
/* V17 holds: a message that comes waits, or is acknowledged again, or is stale, or is older than what the host has. */
A[] Ear.Message imply (waiting[1] || taken[SUPPORT] == 2 || owed[1] == (Support1.lost ? STALE : ACK))
/* V18 holds: a fragment that asks is answered, as long as the whole does not wait. */
A[] Ear.Question imply (waiting[1] || owed[1] == (Support1.Taken && taken[SUPPORT] == 1 ? ACK : FRAGMENTS))
/* V19 holds: a board that begins anew has nothing more to hand over or to answer. */
A[] Ear.ReceiverCut imply (!waiting[1] && !unread[1] && owed[1] == 0 && !again[1] && (Support1.Listening || Support1.Taken) && (Answer1.Idle || Answer1.CutOff))
/* V20 holds: a message can come after a fragment that asks. */
E<> Ear.Message && Support1.Queued && owed[1] == FRAGMENTS
/* V21 holds: a fragment that asks can come after the message has been taken. */
E<> Ear.Question && owed[1] == ACK && Answer1.Idle
/* V22 holds: a board can lose its memory while a message waits. */
E<> Ear.ReceiverCut && Support1.lost && given[1] == 1 && taken[SUPPORT] == 0
/* V23 holds: the board knows what its host has been handed and says that it takes. */
A[] ((Ear.Hands || Ear.HandsAgain) imply Support1.Handed) && (Ear.Takes imply (Support1.Taking || Support1.Taken)) && (Ear.Confirms imply Support1.Taken)
/* V24 holds: a message may be handed again. */
E<> Ear.HandsAgain
/* V25 holds: a host says that it takes it. */
E<> Ear.Takes && Support1.Taking
/* V26 holds: and may say so again. */
E<> Ear.Takes && Support1.Taken
/* V27 holds: its board confirms. */
E<> Ear.Confirms
/* V28 holds: a repeat is answered anew, and not where the answer to the last one waits. */
A[] (Ear.Message || Ear.Question) imply !Answer1.Pending
/* V29 holds: World has no more carriers on the air than it may. */
A[] !World.Ends imply onAir <= CARRIERS + (sending[SUPPORT] ? 1 : 0)
/* V30 holds: what is on the air alone is still being sent. */
A[] (Air.Busy && !collided && from == SUPPORT) imply sending[SUPPORT]
