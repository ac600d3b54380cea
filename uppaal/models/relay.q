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
/* A121 holds: a relay takes what is new: from the sender. */
E<> rule[ONE] == TAKES && by == SENDER
/* A122 holds: a relay takes what is new: from the attacker. */
E<> rule[ONE] == TAKES && by == ATTACKER
/* A123 holds: where its copy is due, it hears that it was handed on: from the sender. */
E<> rule[ONE] == GONE_ON && by == SENDER
/* A124 holds: where its copy is due, it hears that it was handed on: from the attacker. */
E<> rule[ONE] == GONE_ON && by == ATTACKER
/* A125 holds: where its copy is due, it hears a peer: from the sender. */
E<> rule[ONE] == PEER && by == SENDER
/* A126 holds: where its copy is due, it hears a peer: from the attacker. */
E<> rule[ONE] == PEER && by == ATTACKER
/* A127 holds: it hears later that it was handed on: from the sender. */
E<> rule[ONE] == NOTED && by == SENDER
/* A128 holds: it hears later that it was handed on: from the attacker. */
E<> rule[ONE] == NOTED && by == ATTACKER
/* A129 holds: where its copy is due, it is asked again: from the sender. */
E<> rule[ONE] == STILL_ASKS && by == SENDER
/* A130 holds: where its copy is due, it is asked again: from the attacker. */
E<> rule[ONE] == STILL_ASKS && by == ATTACKER
/* A131 holds: it is asked again later: from the sender. */
E<> rule[ONE] == ASKS_AGAIN && by == SENDER
/* A132 holds: it is asked again later: from the attacker. */
E<> rule[ONE] == ASKS_AGAIN && by == ATTACKER
/* A133 holds: it begins anew what comes late: from the sender. */
E<> rule[ONE] == ANEW && by == SENDER
/* A134 holds: it begins anew what comes late: from the attacker. */
E<> rule[ONE] == ANEW && by == ATTACKER
/* A135 holds: it carries an acknowledgement again: from the sender. */
E<> rule[ONE] == REPEATS && by == SENDER
/* A136 holds: it carries an acknowledgement again: from the attacker. */
E<> rule[ONE] == REPEATS && by == ATTACKER
/* A137 holds: the attacker repeats the message with h = 0. */
E<> Air.Carries && by == ATTACKER && kind == DATA && hops == 0 && genuine
/* A138 holds: the attacker repeats the message with h = 1. */
E<> Air.Carries && by == ATTACKER && kind == DATA && hops == 1 && genuine
/* A139 holds: the attacker repeats the message with h = 2. */
E<> Air.Carries && by == ATTACKER && kind == DATA && hops == 2 && genuine
/* A140 holds: the attacker repeats the message with h = 3. */
E<> Air.Carries && by == ATTACKER && kind == DATA && hops == 3 && genuine
/* A141 holds: the attacker repeats an acknowledgement by a relay with h = 0. */
E<> Air.Carries && by == ATTACKER && kind == ACK && hops == 0 && genuine
/* A142 holds: the attacker repeats an acknowledgement by a relay with h = 1. */
E<> Air.Carries && by == ATTACKER && kind == ACK && hops == 1 && genuine
/* A143 holds: the attacker repeats an acknowledgement by a relay with h = 2. */
E<> Air.Carries && by == ATTACKER && kind == ACK && hops == 2 && genuine
/* A144 holds: the attacker repeats an acknowledgement by a relay with h = 3. */
E<> Air.Carries && by == ATTACKER && kind == ACK && hops == 3 && genuine
/* A145 holds: the attacker repeats an acknowledgement from its origin. */
E<> Air.Carries && by == ATTACKER && kind == ACK && hops == DIRECT && genuine
/* A156 holds: the attacker forges an acknowledgement by a relay with h = 0. */
E<> Air.Carries && by == ATTACKER && kind == ACK && hops == 0 && !genuine
/* A157 holds: the attacker forges an acknowledgement by a relay with h = 1. */
E<> Air.Carries && by == ATTACKER && kind == ACK && hops == 1 && !genuine
/* A158 holds: the attacker forges an acknowledgement by a relay with h = 2. */
E<> Air.Carries && by == ATTACKER && kind == ACK && hops == 2 && !genuine
/* A159 holds: the attacker forges an acknowledgement by a relay with h = 3. */
E<> Air.Carries && by == ATTACKER && kind == ACK && hops == 3 && !genuine
/* A160 holds: the attacker forges an acknowledgement from its origin. */
E<> Air.Carries && by == ATTACKER && kind == ACK && hops == DIRECT && !genuine
/* A146 holds: it forges the message. */
E<> Air.Carries && by == ATTACKER && kind == DATA && !genuine
/* A147 holds: it repeats only what it has overheard, and acknowledges only what it knows of. */
A[] (Air.Carries && by == ATTACKER) imply (Thief.shots == 1 && (kind == DATA ? (genuine ? Thief.data : hops == 0) : (genuine ? Thief.ack : Thief.data)))
/* A148 holds: it overhears what is genuine. */
A[] rule[ATTACKER] != 0 imply (kind == rule[ATTACKER] && genuine && (kind == DATA ? Thief.data : Thief.ack))
/* A149 holds: it overhears the message. */
E<> rule[ATTACKER] == DATA
/* A150 holds: it overhears an acknowledgement. */
E<> rule[ATTACKER] == ACK
/* A151 holds: a sender hears a copy by the attacker, while it waits. */
E<> rule[SENDER] == COPIED && by == ATTACKER
/* A152 holds: it hears one when it has stopped waiting. */
E<> rule[SENDER] == COPIED_LATE && by == ATTACKER
/* A153 holds: a sender hears an acknowledgement by the attacker, while it waits. */
E<> rule[SENDER] == DELIVERED && by == ATTACKER
/* A154 holds: it hears one when it has stopped waiting. */
E<> rule[SENDER] == DELIVERED_LATE && by == ATTACKER
/* A155 holds: a copy may be due for longer than the sender waits. */
E<> Home.Contending && Home.attempt == 1 && One.Waiting && One.own == 1 && !One.copied
