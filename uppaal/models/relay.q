/* A21 holds: a relay sends two copies at most for each time that somebody sends the packet. */
A[] One.spent <= 2 * (Home.attempt + Thief.shots)
/* A22 holds: and may send so many. */
E<> One.spent == 2 * (MAX_ATTEMPTS + SHOTS)
/* A23 holds: a forged acknowledgement silences it, and is carried. */
E<> Air.Carries && kind == ACK && by == ONE && !genuine
/* A24 holds: but it reports nothing delivered. */
E<> One.Kept && !One.right && Home.GivenUp && given == 0
/* A26 holds: what is repeated comes to the host once. */
E<> Thief.shots == 1 && Air.Carries && kind == DATA && by == ATTACKER && genuine && given == 1
/* A27 holds: what is forged sets off no copy of this packet. */
A[] (Air.Carries && kind == DATA && by != ATTACKER) imply genuine
