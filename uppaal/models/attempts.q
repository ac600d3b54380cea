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
E<> rule[ONE] == ANEW && One.Waiting && !One.repeated
/* A79 holds: it may use up its time on the air. */
E<> One.Known && One.spent == CREDIT
/* A54 holds: a copy for which none is left is not sent. */
A[] (One.Known && One.spent == CREDIT) imply One.copied
/* A231 holds: a relay that was too late is in reserve later, and steps in. */
E<> rule[ONE] == STEPS_IN && by == SENDER
/* A232 holds: there it may hear an acknowledgement. */
E<> rule[ONE] == RELIEVED && by == RECEIVER
/* A233 holds: it may forget what is asked for too often. */
E<> rule[ONE] == FORGETS && by == SENDER
/* A234 holds: an acknowledgement may come when its sender has stopped waiting. */
E<> rule[SENDER] == DELIVERED_LATE && by == RECEIVER
/* A235 holds: a copy may come so, too. */
E<> rule[SENDER] == COPIED_LATE && by == ONE
/* A236 holds: it begins anew, is asked again, and carries again only in its time. */
A[] !Time.Wrong
/* A237 holds: doubt rises to 3. */
E<> rule[ONE] == NEEDLESS && One.doubt == 3
/* A238 holds: the witness of its time is awake then. */
E<> Time.Right
/* A239 holds: a relay is asked again soon. */
E<> rule[ONE] == ASKS_AGAIN && by == SENDER && Home.attempt == 2
/* A240 holds: an acknowledgement may be lost while its sender waits. */
E<> Air.Over && Home.Awaiting && rule[SENDER] == 0 && kind == ACK && genuine
/* A241 holds: it may be lost when its sender has stopped waiting. */
E<> Air.Over && Home.Contending && rule[SENDER] == 0 && kind == ACK && genuine
/* A242 holds: a message may be lost. */
E<> Air.Over && Away.Listening && kind == DATA && genuine
/* A243 holds: it carries back what it has not copied, */
E<> rule[ONE] == REPEATS && !One.copied
/* A244 holds: 1.5 s later at the earliest. */
A[] Time.Early imply One.copied
/* A245 holds: what it has copied sooner. */
E<> Time.Early
