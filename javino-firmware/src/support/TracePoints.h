// The trace points (Trace.h): POINT(name, first, second), each with what its operands are, a byte each. They are numbered from 1
// in this order. This file is included where a list of them is needed, in C too; the models' edges carry these names.
//
// number: of a transmission (SPEC 4.3, as `host-transmit` has it). key: the key's place in the store, 255 for none. nonce: its last
// byte. slots: drawn at random, quiet slots (SPEC 7.4) that a timer runs for. have: bit k for fragment k.
// clang-format off

// The loop, the air, and all that is counted.
POINT(QUIET, , )                       // run() looks at the air and finds it quiet, as it does before all else for the radio
POINT(BUSY, , )                        // or a carrier, of others or its own. When that is over, quiet slots count from the next QUIET
POINT(COUNT, counter, )                // a counter of SPEC 4.5 grows: why a packet is dropped, a relay refuses, …

// Keys and epochs that are stored.
POINT(MEMORY, kept, )                  // a boot: 1 where RAM still has the nonces that were taken, 0 where only the floors count
POINT(EPOCH_STORED, low, )             // of the boot epoch, whose last byte is this, both copies are in EEPROM
POINT(KEY_STORED, key, )               // a key is in EEPROM, or a session key in RAM
POINT(KEY_DELETED, key, )
POINT(FLOOR_STORED, key, place)        // both copies of a floor, in this place of the ring, are in EEPROM

// A message and its sender (Sender in delivery.xml).
POINT(TURN, number, )                  // those that follow are of this one; also where its outcome is all that follows
POINT(TAKE_UP, key, )                  // it is sealed, unless a broadcast, and waits for its turn
POINT(RESEAL, key, )                   // the same anew, after STALE_HEARD
POINT(CONTEND, slots, )                // an attempt waits for 6 quiet slots in a row and so many further ones
POINT(PASSED, , )                      // a new message goes before it: it waits for its turn again
POINT(SEND, pending, )                 // the radio takes the first of these fragments of an attempt (bit k for fragment k), or the whole
POINT(PART_SENT, , )                   // a fragment has left the air: the next one waits for a quiet slot
POINT(AWAIT, rounds, )                 // an attempt has left the air: its answer has 150 ms of quiet air, and so many times more
POINT(COPIED, , )                      // a relay's copy of it was heard: its answer has 20 times 150 ms from now on
POINT(ATTEMPT_FAILED, attempts, )      // these have passed; so many attempts in a row have come to nothing
POINT(FRAGMENTS_KNOWN, have, )         // an answer tells fragments, none of which is new
POINT(FRAGMENTS_NEW, have, )           // or some are
POINT(STALE_HEARD, , )                 // an answer tells a floor above it: it is UNDELIVERED at once, or waits for RESEAL
POINT(SENT, , )                        // its outcome, which the host is told later
POINT(DELIVERED, , )
POINT(UNDELIVERED, , )

// A message and its receiver (Receiver).
POINT(FRAGMENT, , )                    // one was put to the others of this id (SPEC 7.1)
POINT(QUEUED, nonce, key)              // the inbox takes it in, under the next number; without a key, nonce 0
POINT(HANDED, message, )               // the host is told it (number as in `host-handed`, which begins with 0 at a boot)
POINT(TAKEN, message, )                // the host has taken it, and all before it

// Its acknowledgement (Answer). Of a sender one answer is owed at a time.
POINT(OWE_DELIVERED, nonce, key)       // it takes the place of another one to the same sender
POINT(OWE_FRAGMENTS, nonce, key)
POINT(OWE_STALE, nonce, key)
POINT(OWE_TWICE, , )                   // the one that was owed last is to be sent twice
POINT(PUT_OFF, slots, )                // the first that is owed waits for so many quiet slots, and no longer for one
POINT(ANSWER, key, )                   // the radio takes the first that is owed

// A packet and its relay (relay.xml), which has it in one of its 4 places, each with a number of its own. A copy waits for some
// quiet slots in a row, and for those drawn.
POINT(RELAY_ON, on, )                  // 1: it begins to relay
POINT(RELAY_DISTANCE, place, distance) // one for a device is new: 1 more than its distance modulo 4, or 0 if that is unknown
POINT(RELAY_NEW, place, nonce)         // it takes a packet into this place, whatever was there; its 16th byte, or 0
POINT(RELAY_ANEW, place, )             // one that it knows begins anew, as it comes so late
POINT(RELAY_STEP_IN, place, )          // the same, from reserve
POINT(RELAY_RESERVE, place, )          // it is in reserve, where quiet slots count from here
POINT(RELAY_DRAW, place, slots)        // a copy waits for 8 quiet slots in a row, or 30
POINT(RELAY_DRAW_AGAIN, place, slots)  // for 6, as its sender asks again
POINT(RELAY_DRAW_REPEAT, place, slots) // for 2, as a copy has ended, and is to be followed by another one
POINT(RELAY_COPY, place, path)         // the radio takes the copy
POINT(RELAY_COPY_ENDED, place, )       // it has left the air
POINT(RELAY_REFUSE, place, )           // it is not sent, for want of credit
POINT(RELAY_GONE_ON, place, soon)      // the packet has gone on: 1 where that came soon after a copy
POINT(RELAY_PEER, place, )             // another relay has copied it: no copy waits any more
POINT(RELAY_ANSWERED, place, doubt)    // its acknowledgement comes: the score of the pair is now 0…3
POINT(RELAY_DRAW_ANSWER, place, slots) // a copy of that waits for 1 quiet slot
POINT(RELAY_DRAW_ANSWER_AGAIN, place, slots)   // for 6, as the packet comes again
POINT(RELAY_DRAW_ANSWER_REPEAT, place, slots)  // for 6, as a copy of it has ended, and is to be followed by another one
POINT(RELAY_ANSWER, place, path)       // the radio takes the copy of the acknowledgement
POINT(RELAY_ANSWER_ENDED, place, )     // it has left the air
POINT(RELAY_ANSWER_GONE_ON, place, )   // the acknowledgement has gone on
POINT(RELAY_ANSWER_PEER, place, )      // another relay has copied it
POINT(RELAY_FORGET, place, )           // the packet comes too often behind its acknowledgement, which may be forged

// The law of the air.
POINT(AIRTIME_LIMIT, percent, )        // a boot: the radio may send for so much of each hour

// clang-format on
