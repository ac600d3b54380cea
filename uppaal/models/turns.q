/* U1 holds: a message has its board's turn from when it contends until it has ended or its attempt has failed. */
A[] (turn[POLICE] == 1) == (Police1.Contending || Police1.Deferred || Police1.OnAir || Police1.Awaiting || Police1.Held) && (turn[POLICE] == 2) == (Police2.Contending || Police2.Deferred || Police2.OnAir || Police2.Awaiting || Police2.Held)
/* U2 holds: each host gets its message, and once. */
A[] given[1] <= 1 && given[2] <= 1 && (Police1.Answered imply given[1] == 1) && (Police2.Answered imply given[2] == 1)
/* U3 holds: two messages are under way at once, and the board knows how many. */
A[] active == (Police1.Ready || Police1.Contending || Police1.Deferred || Police1.OnAir || Police1.Awaiting || Police1.Held ? 1 : 0) + (Police2.Ready || Police2.Contending || Police2.Deferred || Police2.OnAir || Police2.Awaiting || Police2.Held ? 1 : 0)
/* U4 holds: one waits for its turn while the other has it. */
E<> Police1.Ready && Police1.attempt == 1 && turn[POLICE] == 2
/* U5 holds: an acknowledgement for one that waits for its turn is taken, too. */
E<> Police1.Answered && turn[POLICE] == 2 && Police2.Held
/* U6 holds: nothing is stuck before all has ended. */
A[] deadlock imply (Police1.Over && Police2.Over && Answer1.Idle && Answer2.Idle)
/* U7 holds: no board answers for another. */
A[] (Answer1.OnAir imply given[1] == 1) && (Answer2.OnAir imply given[2] == 1) && sending[SUPPORT] == Answer1.OnAir && sending[HOSPITAL] == Answer2.OnAir
/* U8 holds: it may be lost, too. */
E<> Police1.Ready && Air.Freeing && !collided && kind == ACK && nonce == 1 && genuine
