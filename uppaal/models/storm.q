/* A51 fails: where the air is so busy that copies wait for longer than 1.5 s, two relays set each other off. */
A[] One.spent <= 2 * Home.attempt && Two.spent <= 2 * Home.attempt
/* A52 holds: then only their time on the air bounds them. */
A[] One.spent <= CREDIT && Two.spent <= CREDIT
/* A53 holds: both may use it up for one attempt. */
E<> Home.attempt == 1 && One.spent == CREDIT && Two.spent == CREDIT
/* A54 holds: a copy for which none is left is not sent. */
A[] (One.Known && One.spent == CREDIT) imply One.copied
/* A55 holds: what a relay owes is sent, or is no longer due. */
(One.Waiting || One.Carrying) --> (!One.Waiting && !One.Carrying)
