/* A251 holds: a relay that is away is silent as long as the packet comes once. */
A[] One.copied imply Home.attempt > 1
/* A252 holds: it brings on what comes again. */
E<> Home.Delivered && One.reserved && One.answers > 0
/* A253 holds: it begins anew what comes late, */
E<> rule[ONE] == ANEW && !One.copied && !One.repeated
/* A254 holds: and brings that on. */
E<> Home.Delivered && !One.reserved && One.answers > 0
/* A255 holds: what begins anew is in reserve only for its score. */
A[] One.Reserve imply (One.away || One.doubt == MOST)
/* A256 holds: A236 for it. */
A[] !Time.Wrong
/* A257 holds: A238 for it. */
E<> Time.Right
