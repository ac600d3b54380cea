// Packets that somebody damages on purpose, and what boards make of them.

#include "attacks/attacks.h"

#include "support/Victim.h"

namespace {

const double RATES[] = {0.003, 0.01, 0.03, 0.06, 0.12};

double someRate(RandomBytes &random) { return RATES[random.number(5)]; }

const int COPIES = 8;

}  // namespace

// A frame that only comes damaged is that frame, or none.
Tally damageFrames(uint32_t seed, uint64_t tries) {
  Victim victim(seed);
  victim.board.radio.mends = true;
  return victim.endure(tries, [&] {
    const Bytes frame = victim.genuine(16 + victim.random.number(30), victim.random.number(4) == 0);
    const double rate = someRate(victim.random);
    victim.allow(frame);
    for (int copy = 0; copy < COPIES; copy++) victim.suffer(frame, rate);
    victim.take();
    victim.disallow();
    victim.deliver(victim.genuine(16, false));
  });
}

// Between the copies are others that differ in a few bytes, so that they are taken for copies too.
Tally imitateFrames(uint32_t seed, uint64_t tries) {
  Victim victim(seed);
  victim.board.radio.mends = true;
  return victim.endure(tries, [&] {
    const Bytes frame = victim.genuine(40, false);
    const double rate = someRate(victim.random);
    victim.allow(frame);
    for (int copy = 0; copy < COPIES; copy++) {
      Bytes changed = frame;
      for (uint32_t left = victim.random.number(5); left != 0; left--)
        changed[victim.random.number(static_cast<uint32_t>(changed.size()))] = victim.random.byte();
      victim.suffer(changed, copy % 2 == 0 ? rate : 0);
      if (victim.random.number(3) == 0) victim.suffer(frame, rate);
    }
    victim.take();
    victim.disallow();
    victim.deliver(victim.genuine(16, false));
  });
}
