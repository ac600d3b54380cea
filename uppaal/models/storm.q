/* A51 holds: even where the air is so busy that copies wait for longer than 1.5 s, two relays do not set each other off. */
A[] One.spent <= 2 * Home.attempt && Two.spent <= 2 * Home.attempt
/* A52 holds: both may send so many. */
E<> Home.attempt == 1 && One.spent == 2 && Two.spent == 2
/* A53 holds: one that has copied nothing begins anew what comes late. */
E<> rule[TWO] == ANEW && !Two.copied && by == ONE
/* A55 holds: what a relay owes is sent, or is no longer due. */
(One.Waiting || One.Carrying) --> (!One.Waiting && !One.Carrying)
