// World does all that others may do, with one carrier at a time.

/* G1 holds: a multicast in fragments is sent as often as it is to be, and no more. */
A[] Police1.Sent imply Police1.attempt == MULTICAST_SENDS
/* G2 holds: it keeps its board's turn until then. */
A[] (turn[POLICE] == 1) == (Police1.Contending || Police1.Deferred || Police1.Part || Police1.OnAir || Police1.Pausing || Police1.PutOff || Police1.CutOff)
/* G3 holds: then the board knows that it has ended. */
A[] (ended[POLICE] == 1) == (Police1.Sent || Police1.Over) && active == (ended[POLICE] == 0 && !Police1.New ? 1 : 0)
/* G4 holds: each attempt begins with one packet, which others follow. */
A[] (Police1.Part || Police1.Pausing || Police1.PutOff) imply Police1.attempt > 0
/* G5 holds: others follow. */
E<> Police1.Part && Police1.attempt == MULTICAST_SENDS
/* G6 holds: it has the transmitter from each packet's begin to its end. */
A[] ((Police1.Part || Police1.OnAir || Police1.CutOff) imply (sending[POLICE] && !World.mine && onAir > 0)) && (sending[POLICE] imply (World.mine || World.Begins || World.Ends || Police1.Part || Police1.OnAir || Police1.CutOff)) && (Police1.CutOff imply collided)
/* G7 holds: each packet is for the group. */
A[] ((Police1.OnAir || Police1.Part) && !collided && World.There && kind > 0) imply (kind == (Police1.Part ? PART : DATA) && to == SAFETY_GROUP && from == POLICE && nonce == 1 && genuine)
/* G8 holds: who waits for the air knows whether a carrier is there. */
A[] ((Police1.Contending || Police1.Pausing) imply !busy) && ((Police1.Deferred || Police1.PutOff) imply (busy || Air.Starting))
/* G9 holds: no answer is awaited. */
A[] !(Police1.Awaiting || Police1.Held || Police1.Answered || Police1.Refused || Police1.GivenUp)
/* G10 holds: a repeat contends in a window that is twice as wide. */
A[] Police1.Contending imply Police1.span == (Police1.attempt == 0 ? LEAST_WINDOW : LAST_WINDOW)
/* G11 holds: it can be sent. */
E<> Police1.Sent && Air.Quiet
/* G12 holds: nothing is ever stuck. */
A[] not deadlock
/* G13 holds: a multicast that contends has attempts left. */
A[] (Police1.Contending || Police1.Deferred) imply Police1.attempt < MULTICAST_SENDS
/* G14 holds: World has no more carriers on the air than it may. */
A[] !World.Ends imply onAir <= CARRIERS + (sending[POLICE] ? 1 : 0)
/* G15 holds: the host is told that it was sent when that is so. */
A[] (Ends.Sent imply Police1.attempt == MULTICAST_SENDS) && !Ends.Delivered && !Ends.Undelivered
/* G16 holds: it is told. */
E<> Ends.Sent
/* G17 holds: it waits for a quiet slot after each packet, of its own, too. */
A[] (Early.Before && !collided) imply !(Police1.Part || Police1.OnAir)
/* G18 holds: and may send the next packet then. */
E<> Early.Just && Police1.Part && kind == PART
/* G19 holds: nor for a longer time. */
A[] (Early.After && !collided) imply !Police1.Part
/* G20 holds: what its board was about when it was reset is over. */
A[] Ear.SenderCut imply (Police1.Over || Police1.CutOff)
/* G21 holds: other fragments follow the one that begins an attempt. */
A[] (Air.Heard && kind == DATA && from == POLICE) imply Police1.PutOff
/* G22 holds: what is on the air alone is still being sent. */
A[] (Air.Busy && !collided && from == POLICE) imply sending[POLICE]
