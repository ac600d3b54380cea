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
