// Messages in fragments that were never sent so.

#include "attacks/attacks.h"
#include "support/Victim.h"

namespace {

const uint32_t EXPIRY = 5000;  // of a message that gets no more fragments, in ms
const size_t PART = 67;

Bytes longFrame(Victim &victim) { return victim.genuine(60 + victim.random.number(430), victim.random.number(3) == 0); }

std::string anyOrigin(RandomBytes &random) {
  std::string origin;
  origin += digit(random.number(62));
  for (int i = 0; i < 3; i++) origin += digit(random.number(64));
  return random.number(4) == 0 ? "ROMA" : origin;
}

// A first fragment that looks like that of a message to the board.
Bytes forgedFirst(const std::string &origin, unsigned id, unsigned bytes, RandomBytes &random) {
  const std::string header =
      std::string(random.number(3) == 0 ? "//SU" : "SUPO") + origin + digit(bytes * 8 / 64) + digit(bytes * 8);
  return fragment(origin, id, random.number(2) * 8, bytesOf(header) + random.bytes(PART - 10));
}

}  // namespace

Tally mixFragments(uint32_t seed, uint64_t tries) {
  Victim victim(seed);
  return victim.endure(tries, [&] {
    const size_t length = 60 + victim.random.number(430);
    const bool toGroup = victim.random.number(3) == 0;
    const Bytes first = victim.genuine(length, toGroup);
    const Bytes second = victim.genuine(length, toGroup);
    const unsigned id = victim.random.number(64);
    const std::vector<Bytes> sources[] = {fragmentsOf(first, id), fragmentsOf(second, id)};
    const uint32_t all = (1u << sources[0].size()) - 1;
    for (int i = 0; i < 50; i++) {
      const uint32_t choice = 1 + victim.random.number(all - 1);  // of both at least one
      std::vector<Bytes> mixed;
      for (size_t k = 0; k < sources[0].size(); k++) mixed.push_back(sources[choice >> k & 1][k]);
      shuffle(mixed, victim.random);
      victim.tally.tries++;
      for (const Bytes &packet : mixed) victim.hear(packet);
      victim.skip(EXPIRY);
      victim.take();
    }
    victim.deliver(first);
    victim.deliver(second);
  });
}

Tally forgeFragments(uint32_t seed, uint64_t tries) {
  Victim victim(seed);
  return victim.endure(tries, [&] {
    for (int i = 0; i < 100; i++) {
      const std::string origin = anyOrigin(victim.random);
      const unsigned id = victim.random.number(4);
      const unsigned bytes = 68 + victim.random.number(444);
      const size_t whole = 10 + bytes;
      victim.suffer(forgedFirst(origin, id, bytes, victim.random));
      for (unsigned index = 1; index * PART < whole; index++) {
        const size_t fits = whole - index * PART < PART ? whole - index * PART : PART;
        const size_t length = victim.random.number(8) == 0 ? victim.random.number(PART + 1) : fits;
        victim.suffer(fragment(origin, id, index + victim.random.number(2) * 8, victim.random.bytes(length)));
      }
      victim.suffer(
          fragment(origin, id, victim.random.number(64), victim.random.bytes(victim.random.number(PART + 1))));
      victim.skip(victim.random.number(500));
    }
    victim.skip(EXPIRY);
    victim.deliver(longFrame(victim));
  });
}

Tally floodWithFirstFragments(uint32_t seed, uint64_t tries) {
  Victim victim(seed);
  return victim.endure(tries, [&] {
    for (int i = 0; i < 20; i++) {
      for (int k = 0; k < 20; k++) {
        victim.suffer(forgedFirst(anyOrigin(victim.random), victim.random.number(64), 68 + victim.random.number(444),
                                  victim.random));
        victim.skip(victim.random.number(600));
      }
      victim.deliver(victim.genuine(16, i % 2 != 0));
    }
    victim.skip(EXPIRY);
    victim.deliver(longFrame(victim));
  });
}
