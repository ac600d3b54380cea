// For quiet.xml, together with the properties of stronger.q.

/* Q1 holds: with a connection that stays online, the network has no deadlock either. */
A[] not deadlock
