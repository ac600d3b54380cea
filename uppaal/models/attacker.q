// The attacker acts of itself, so that what holds against it says something.

/* T1 holds: it sends as the one board or as the other. */
A[] (Thief.OnAir && !collided) imply (nonce > 0 && (kind == DATA && to == SUPPORT && from == POLICE || kind == ACK && to == POLICE && from == SUPPORT))
/* T2 holds: what it cannot seal it has overheard. */
A[] (Thief.OnAir && genuine && !collided) imply (kind == DATA ? (nonce == 1 ? Thief.data1 && Police1.attempt > 0 : Thief.data2 && Police2.attempt > 0) : (nonce == 1 ? Thief.ack1 && given[1] > 0 : Thief.ack2 && given[2] > 0))
/* T3 holds: it sends no more than it may. */
A[] Thief.shots <= SHOTS && (Thief.OnAir imply Thief.shots > 0)
/* T4 holds: it plays a message again when that was taken. */
E<> Thief.OnAir && !collided && genuine && kind == DATA && nonce == 1 && Support1.Taken
/* T5 holds: and when it has ended. */
E<> Thief.OnAir && !collided && genuine && kind == DATA && nonce == 2 && Police2.Over
/* T6 holds: it plays an acknowledgement again while the next one is awaited. */
E<> Thief.OnAir && !collided && genuine && kind == ACK && nonce == 1 && Police2.Held
/* T7 holds: or after its own. */
E<> Thief.OnAir && !collided && genuine && kind == ACK && nonce == 2
/* T8 holds: it forges a message before there is one. */
E<> Thief.OnAir && !collided && !genuine && kind == DATA && nonce == 1 && Police1.New
/* T9 holds: and the next one. */
E<> Thief.OnAir && !collided && !genuine && kind == DATA && nonce == 2 && Police2.New
/* T10 holds: it forges the acknowledgement that is awaited. */
E<> Thief.OnAir && !collided && !genuine && kind == ACK && nonce == 1 && Police1.Held
/* T11 holds: and that of the next one. */
E<> Thief.OnAir && !collided && !genuine && kind == ACK && nonce == 2 && Police2.Held
/* T12 holds: what it has sent comes. */
E<> Air.Heard && kind == ACK && !genuine
/* T13 holds: it overhears messages that the receiver has lost. */
E<> Thief.data1 && Thief.data2 && given[1] == 0 && given[2] == 0
/* T14 holds: it overhears only what has ended. */
A[] Thief.shots == 0 imply (((Police1.OnAir && Police1.attempt == 1) imply !Thief.data1) && ((Police2.OnAir && Police2.attempt == 1) imply !Thief.data2) && ((Answer1.OnAir && Police1.attempt == 1) imply !Thief.ack1) && ((Answer2.OnAir && Police2.attempt == 1) imply !Thief.ack2))
/* T15 holds: and only what is genuine. */
A[] (Thief.data1 imply Police1.attempt > 0) && (Thief.data2 imply Police2.attempt > 0) && (Thief.ack1 imply given[1] > 0) && (Thief.ack2 imply given[2] > 0)
