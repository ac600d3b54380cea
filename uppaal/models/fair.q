/* F1 holds: a message is delivered in the end. */
Police1.Ready --> Police1.Answered
/* F2 holds: so is the next one. */
Police2.Ready --> Police2.Answered
/* F3 holds: over a channel that loses fewer packets than there are attempts, a message is delivered. */
A[] !Police1.GivenUp && !Police2.GivenUp
/* F4 holds: nobody starves: who contends sends. */
Police1.Contending --> Police1.OnAir
/* F5 holds: what is owed is answered. */
Answer1.Pending --> Answer1.OnAir
/* F6 holds: a message may be lost. */
E<> losses == LOSSES && Support1.Listening && Police1.Awaiting
/* F7 holds: and an answer. */
E<> losses == LOSSES && Support1.Taken && Police1.Awaiting && Answer1.Idle && owed[1] == 0
/* F8 holds: the receiver's board knows what its host has taken. */
A[] waiting[1] == Support1.Queued && unread[1] == Support1.Queued && waiting[2] == Support2.Queued && unread[2] == Support2.Queued && given[1] == (Support1.Taken ? 1 : 0) && given[2] == (Support2.Taken ? 1 : 0) && taken[SUPPORT] == (Support2.Taken ? 2 : Support1.Taken ? 1 : 0)
/* F9 holds: each attempt after the first costs a loss, and a message that is answered at once has cost none. */
A[] (Police1.Over && Police2.New) imply (losses >= Police1.attempt - 1 && (Police1.attempt == 1 imply losses == 0))
