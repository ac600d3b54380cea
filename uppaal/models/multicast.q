/* M1 holds: a host of the group gets each multicast at most once. */
A[] given[1] <= 1 && given[2] <= 1
/* M2 holds: it gets nothing that was not sent. */
A[] (given[1] > 0 imply Police1.attempt > 0) && (given[2] > 0 imply Police2.attempt > 0)
/* M3 holds: nobody outside the group gets any. */
A[] Hospital1.Listening
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
A[] Police2.OnAir imply (Police1.Sent || Police1.Over)
