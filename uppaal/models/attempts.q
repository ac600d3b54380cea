/* A71 holds: all attempts can be used. */
E<> Home.GivenUp
/* A72 holds: a relay sends two copies at most for each. */
A[] One.spent <= 2 * Home.attempt
/* A73 holds: where an acknowledgement has been carried four times and its packet comes again, that begins anew. */
E<> One.Empty && One.doubt == NO_DOUBT && given == 1
/* A74 holds: that can be delivered, too. */
E<> Home.Delivered && One.spent == 0 && Home.attempt == 7
/* A75 holds: from the third attempt on a sender waits for longer. */
E<> Home.Awaiting && !Watch.copied && Home.rounds == LATE_ROUNDS && Home.attempt == LATE_ATTEMPT + 1
/* A76 holds: one in doubt sends nothing once more of its own accord. */
A[] (One.Waiting && One.doubt == FIRST) imply One.repeated
/* A77 holds: where nothing of it soon brings the message on, its doubt rises. */
E<> One.doubt == MOST && One.copied
/* A78 holds: one that has brought it on repeats what begins anew. */
E<> One.Waiting && One.late && !One.repeated
