// Frames that were changed, or made without the key.

#include "attacks/attacks.h"
#include "support/Victim.h"

namespace {

const size_t LENGTHS[] = {8, 16, 17, 32, 53};  // of contents, in one packet
const uint8_t HEADER = 10;
const uint8_t TAG = 8;

Bytes anyFrame(Victim &victim) {
  return victim.genuine(LENGTHS[victim.random.number(5)], victim.random.number(2) != 0);
}

Bytes withBit(Bytes frame, size_t bit) {
  frame[bit / 8] = static_cast<uint8_t>(frame[bit / 8] ^ 1 << bit % 8);
  return frame;
}

void replace(Bytes &frame, size_t from, size_t to, RandomBytes &random) {
  for (size_t i = from; i < to; i++) frame[i] = random.byte();
}

void setSize(Bytes &frame) {
  const unsigned bits = static_cast<unsigned>((frame.size() - HEADER) * 8);
  frame[8] = static_cast<uint8_t>(digit(bits / 64));
  frame[9] = static_cast<uint8_t>(digit(bits));
}

}  // namespace

Tally changeEachBit(uint32_t seed, uint64_t tries) {
  Victim victim(seed);
  unsigned i = 0;
  return victim.endure(tries, [&] {
    const Bytes frame = victim.genuine(LENGTHS[i % 5], i / 5 % 2 != 0);
    i++;
    for (size_t bit = 0; bit < 8 * frame.size(); bit++) victim.suffer(withBit(frame, bit));
    victim.deliver(frame);
  });
}

Tally changeEachBitOfFragments(uint32_t seed, uint64_t tries) {
  Victim victim(seed);
  return victim.endure(tries, [&] {
    const Bytes frame = victim.genuine(54 + victim.random.number(441), victim.random.number(2) != 0);
    for (size_t bit = 0; bit < 8 * frame.size() && victim.tally.tries < tries; bit++) {
      victim.tally.tries++;
      for (const Bytes &packet : fragmentsOf(withBit(frame, bit), victim.random.number(64))) victim.hear(packet);
      victim.skip(5000);
    }
    victim.deliver(frame);
  });
}

Tally changeManyBits(uint32_t seed, uint64_t tries) {
  Victim victim(seed);
  return victim.endure(tries, [&] {
    const Bytes frame = anyFrame(victim);
    for (int i = 0; i < 500; i++) {
      Bytes changed = frame;
      const size_t from = victim.random.number(static_cast<uint32_t>(frame.size()));
      replace(changed, from, from + 1 + victim.random.number(static_cast<uint32_t>(frame.size() - from)),
              victim.random);
      const bool isPlain = changed[0] == '/' && changed[1] == '/' && changed[2] == '/' && changed[3] == '/';
      if (changed != frame && !isPlain) victim.suffer(changed);
    }
    victim.deliver(frame);
  });
}

Tally guessTags(uint32_t seed, uint64_t tries) {
  Victim victim(seed);
  return victim.endure(tries, [&] {
    const Bytes frame = anyFrame(victim);
    for (int i = 0; i < 500; i++) {
      Bytes forged = frame;
      if (i % 2 != 0) replace(forged, HEADER, forged.size() - TAG, victim.random);
      replace(forged, forged.size() - TAG, forged.size(), victim.random);
      victim.suffer(forged);
    }
    victim.deliver(frame);
  });
}

Tally changeLengths(uint32_t seed, uint64_t tries) {
  Victim victim(seed);
  return victim.endure(tries, [&] {
    const Bytes frame = anyFrame(victim);
    for (size_t length = 0; length <= javinolib::MAX_RADIO_PAYLOAD; length++) {
      if (length == frame.size() || length == 0) continue;
      Bytes other = frame;
      other.resize(length, victim.random.byte());
      victim.suffer(other);
      if (length <= HEADER) continue;
      setSize(other);  // so that the frame has the right form
      victim.suffer(other);
    }
    victim.deliver(frame);
  });
}

Tally changeAddresses(uint32_t seed, uint64_t tries) {
  Victim victim(seed);
  const char *const others[] = {"SUPO", "//SU", "ROMA", "SUHO", "//RO", "AAAA", "+FAA", "+KAA", "++++"};
  return victim.endure(tries, [&] {
    const Bytes frame = anyFrame(victim);
    const std::string destination(frame.begin(), frame.begin() + 4);
    for (const char *to : others) {
      for (const char *from : others) {
        if (to == destination && from == std::string("ROMA")) continue;
        victim.suffer(bytesOf(std::string(to) + from) + Bytes(frame.begin() + 8, frame.end()));
      }
    }
    victim.deliver(frame);
  });
}

Tally sealWithOtherKeys(uint32_t seed, uint64_t tries) {
  Victim victim(seed);
  return victim.endure(tries, [&] {
    for (int i = 0; i < 500; i++) {
      // Each key for what the other is for, then keys that are near to the right one, then any.
      const bool toGroup = victim.random.number(2) != 0;
      Bytes key = toGroup == (i % 3 != 0) ? Victim::groupKey() : Victim::pairKey();
      if (i % 3 == 1) key = withBit(key, victim.random.number(128));
      if (i % 3 == 2) key = victim.random.bytes(16);
      Bytes nonce = victim.random.bytes(6);
      victim.suffer(sealed(key, toGroup ? "//SU" : "SUPO", "ROMA", nonce, "tell;forged"));
    }
    victim.deliver(anyFrame(victim));
  });
}
