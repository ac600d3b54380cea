// An attacker with 5 % of the air and all that is said on it, but no key: what he costs long messages.

#include <gtest/gtest.h>

#include <functional>
#include <iostream>
#include <map>

#include "support/Air.h"
#include "support/Digits.h"
#include "support/Keys.h"
#include "support/Reference.h"

namespace {

const uint32_t MILLIS = 100000;
const uint32_t ID_AT = 2;
const uint32_t INDEX_AT = 3;
const uint32_t MESSAGE_AT = 10;
const size_t PART = 67;

uint32_t airtime(const Bytes &packet) { return 42 + 6 * static_cast<uint32_t>(packet.size()); }

std::string header(const std::string &to, const std::string &from, size_t length) {
  return to + from + digits()[length * 8 / 64] + digits()[length * 8 % 64];
}

// Listens, and sends as soon as a fragment has ended: before its sender goes on, so that nothing collides.
class Attacker {
 public:
  // Makes a packet of what was heard: the last fragment, its id and index, and the last first fragment of another message.
  struct Heard {
    Bytes fragment;
    uint8_t id;
    uint8_t index;
    Bytes recorded;
    Bytes first;
  };
  typedef std::function<Bytes(const Heard &heard, RandomBytes &random)> Forger;

  Attacker(Air &air, double share, Forger forge) : air_(air), share_(share), forge_(forge), random_(5) {
    air_.onPacket = [this](const Bytes &packet) { hear(packet); };
  }

  void step() {
    budget_ += share_;
    if (ends_ == 0 || --ends_ != 0 || share_ == 0) return;
    const Bytes packet = forge_(heard_, random_);
    if (packet.empty() || budget_ < airtime(packet)) return;
    budget_ -= airtime(packet);
    sending_ = true;
    air_.inject(packet);
    sending_ = false;
    used += airtime(packet);
  }

  uint32_t used = 0;

 private:
  void hear(const Bytes &packet) {
    if (sending_ || packet[0] != '+' || packet[1] != 'F') return;
    heard_.fragment = packet;
    heard_.id = static_cast<uint8_t>(digits().find(static_cast<char>(packet[ID_AT])));
    heard_.index = static_cast<uint8_t>(digits().find(static_cast<char>(packet[INDEX_AT])) & 7);
    if (heard_.index == 0 && packet != heard_.first) {
      heard_.recorded = heard_.first;
      heard_.first = packet;
    }
    ends_ = airtime(packet) + 1;
  }

  Air &air_;
  const double share_;
  const Forger forge_;
  RandomBytes random_;
  Heard heard_;
  double budget_ = 0;
  uint32_t ends_ = 0;  // ms until the fragment that is on the air has ended
  bool sending_ = false;
};

Bytes forged(unsigned id, unsigned index, const Bytes &part) {
  return bytesOf(std::string("+F") + digits()[id % 64] + digits()[index] + header("", "SUPO", part.size())) + part;
}

// Long messages that are delivered while an attacker forges, of any that fit into the time.
int delivered(uint32_t seed, size_t length, double share, Attacker::Forger forge) {
  Air air(seed);
  Station from("SUPO");
  Station to("SUPP");
  from.share(to, KEY);
  air.join(from);
  air.join(to);
  Attacker attacker(air, share, forge);
  int number = 0;
  for (uint32_t millis = 0; millis < MILLIS; millis++) {
    if (from.underWay.empty()) {
      std::string content = "tell;m" + std::to_string(number++) + ".";
      content.resize(length, static_cast<char>('a' + number % 26));
      from.send("SUPP", content);
    }
    air.step();
    attacker.step();
  }
  EXPECT_GT(share == 0 ? 1 : attacker.used, share == 0 ? 0 : MILLIS * share * 0.3)
      << "the attacker has not used his share";
  return static_cast<int>(to.received.size());
}

struct Kind {
  const char *name;
  size_t length;  // of the messages' contents
  Attacker::Forger forge;
};

const size_t LONGEST = 494;

const Kind KINDS[] = {
    {"a last fragment of one byte", LONGEST,
     [](const Attacker::Heard &heard, RandomBytes &random) {
       return forged(heard.id, 1 + random.number(7), random.bytes(1));
     }},
    {"a last fragment of one byte of the message to come", LONGEST,
     [](const Attacker::Heard &heard, RandomBytes &random) {
       return heard.index == 7 ? forged(heard.id + 1, 1 + random.number(7), random.bytes(1)) : Bytes();
     }},
    {"a last fragment of the right length", LONGEST,
     [](const Attacker::Heard &heard, RandomBytes &random) {
       return forged(heard.id, 7, random.bytes(518 - 7 * PART));
     }},
    {"a last fragment of the right length, of one byte", 7 * PART + 1 - 24,
     [](const Attacker::Heard &heard, RandomBytes &random) { return forged(heard.id, 7, random.bytes(1)); }},
    {"the fragment that comes next", LONGEST,
     [](const Attacker::Heard &heard, RandomBytes &random) {
       return forged(heard.id, (heard.index + 1u) % 7, random.bytes(PART));
     }},
    {"the fragment that has come", LONGEST,
     [](const Attacker::Heard &heard, RandomBytes &random) {
       return heard.index % 7 == 0 ? Bytes() : forged(heard.id, heard.index, random.bytes(PART));
     }},
    {"a first fragment of another length", LONGEST,
     [](const Attacker::Heard &heard, RandomBytes &random) {
       return forged(heard.id, 0, bytesOf(header("SUPP", "SUPO", 2 * PART - 10)) + random.bytes(PART - 10));
     }},
    {"a first fragment of the same length", LONGEST,
     [](const Attacker::Heard &heard, RandomBytes &random) {
       return forged(heard.id, 0, bytesOf(header("SUPP", "SUPO", LONGEST + 14)) + random.bytes(PART - 10));
     }},
    {"a first fragment of the message to come", LONGEST,
     [](const Attacker::Heard &heard, RandomBytes &random) {
       return forged(heard.id + 1, 0, bytesOf(header("SUPP", "SUPO", 2 * PART - 10)) + random.bytes(PART - 10));
     }},
    {"a first fragment to another device", LONGEST,
     [](const Attacker::Heard &heard, RandomBytes &random) {
       return forged(heard.id, 0, bytesOf(header("SUHO", "SUPO", LONGEST + 14)) + random.bytes(PART - 10));
     }},
    {"the first fragment of the message before, with this one's id", LONGEST,
     [](const Attacker::Heard &heard, RandomBytes &) {
       if (heard.recorded.empty() || heard.index == 0) return Bytes();
       return forged(heard.id, 0, Bytes(heard.recorded.begin() + MESSAGE_AT, heard.recorded.end()));
     }},
};

}  // namespace

TEST(ForgedFragments, with_5_percent_of_the_air_cost_15_percent_of_the_long_messages_at_most) {
  const uint32_t SEEDS = 2;
  std::map<size_t, int> before;  // by length
  for (const Kind &kind : KINDS) {
    int under = 0;
    for (uint32_t seed = 1; seed <= SEEDS; seed++) {
      under += delivered(seed, kind.length, 0.05, kind.forge);
    }
    if (before.count(kind.length) == 0) {
      for (uint32_t seed = 1; seed <= SEEDS; seed++) before[kind.length] += delivered(seed, kind.length, 0, kind.forge);
    }
    EXPECT_GE(under, before[kind.length] * 85 / 100) << kind.name;
    std::cout << kind.name << ": " << under << " of " << before[kind.length] << std::endl;
  }
}
