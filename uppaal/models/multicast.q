/* M1 holds: a host of the group gets each multicast at most once. */
A[] given[1] <= 1 && given[2] <= 1
/* M2 holds: it gets nothing that was not sent. */
A[] (given[1] > 0 imply Police1.attempt > 0) && (given[2] > 0 imply Police2.attempt > 0)
/* M3 holds: nobody outside the group gets any, and nobody answers. */
A[] Hospital1.Listening && owed[1] == 0 && owed[2] == 0
/* M4 holds: nothing is accepted that is older than what the host has. */
A[] (waiting[1] imply taken[SUPPORT] < 1) && (waiting[2] imply taken[SUPPORT] < 2)
/* M5 holds: nothing is stuck before all messages have been sent. */
A[] deadlock imply (Police1.Over && Police2.Over)
/* M6 holds: both can be received. */
E<> given[1] == 1 && given[2] == 1
/* M7 holds: each is sent as often as it is to be, and no more. */
A[] (Police1.Sent imply Police1.attempt == MULTICAST_SENDS) && (Police2.Sent imply Police2.attempt == MULTICAST_SENDS)
/* M8 holds: nobody begins to send while a carrier is heard. */
A[] !late
/* M9 holds: multicasts are under way one after the other. */
A[] !Police2.New imply (Police1.Sent || Police1.Over)
/* M10 holds: a multicast keeps its turn until it was sent as often as it is to be. */
A[] (turn[POLICE] == 1) == (Police1.Contending || Police1.Deferred || Police1.OnAir) && (turn[POLICE] == 2) == (Police2.Contending || Police2.Deferred || Police2.OnAir)
/* M11 holds: then the board knows that it has ended. */
A[] (ended[POLICE] > 0) == (Police1.Sent || Police1.Over) && (ended[POLICE] == 2) == (Police2.Sent || Police2.Over) && active == (ended[POLICE] == 0 && !Police1.New || ended[POLICE] == 1 && !Police2.New ? 1 : 0)
/* M12 holds: its transmitter has one packet at a time. */
A[] sending[POLICE] == (Police1.OnAir || Police2.OnAir)
/* M13 holds: a repeat contends in a window that is twice as wide. */
A[] Police1.Contending imply Police1.span == (Police1.attempt == 0 ? LEAST_WINDOW : 2 * LEAST_WINDOW)
/* M14 holds: the other board knows which multicast its host has been told of, and which it has taken. */
A[] waiting[1] == (Support1.Queued || Support1.Handed || Support1.Taking) && waiting[2] == (Support2.Queued || Support2.Handed || Support2.Taking) && taken[SUPPORT] == (Support2.Taken ? 2 : Support1.Taken ? 1 : 0)
/* M15 holds: a multicast may be received twice, of which the host gets one. */
E<> given[1] == 1 && Police1.OnAir && Police1.attempt == 2
/* M16 holds: a multicast that contends has attempts left. */
A[] ((Police1.Contending || Police1.Deferred) imply Police1.attempt < MULTICAST_SENDS) && ((Police2.Contending || Police2.Deferred) imply Police2.attempt < MULTICAST_SENDS)
/* M17 holds: nothing is received before its packet has ended. */
A[] ((Police1.OnAir && Police1.attempt == 1) imply Support1.Listening) && ((Police2.OnAir && Police2.attempt == 1) imply Support2.Listening)
/* M18 holds: who contends waits for the first quiet slots; only the attacker does not. */
A[] Early.Before imply Thief.OnAir
/* M19 holds: and may begin then. */
E<> Early.Just && Police1.OnAir && Police1.attempt == 2 && !Thief.OnAir
