// Properties of the air, in each scene of delivery.

/* A1 holds: the air is quiet when nobody sends. */
A[] Air.Quiet == (onAir == 0) && (Air.Quiet imply !collided)
/* A2 holds: a carrier is heard from its second slot on, until its end. */
A[] busy == (Air.Busy || Air.Heard || Air.Freeing)
/* A3 holds: a packet is heard where nobody else has sent meanwhile. */
A[] Air.Heard imply (onAir == 1 && !collided)
/* A4 holds: packets may be heard. */
E<> Air.Heard
/* A5 holds: losses are counted only where a channel is fair. */
A[] losses > 0 imply FAIR
