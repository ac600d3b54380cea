// Answers to what the board sends itself, from one who has no key.

#include "attacks/attacks.h"

#include <secure/Proof.h>

#include "support/Victim.h"

using javinolib::Proof;

namespace {

const uint8_t NONCE_AT = 10;
const uint8_t HEADER = 10;

/// The board's own unicasts to ROMA, one at a time.
class Errand {
 public:
  explicit Errand(Victim &victim) : victim_(victim) { send(); }

  const Bytes &nonce() const { return nonce_; }

  /// The packet that is on the air once more when no answer came.
  Bytes repeated() { return victim_.board.sendNext(); }
  const Bytes &packet() const { return packet_; }

  /// Whether the board has reported an outcome, though ROMA has said nothing: counted as accepted.
  void checkUndecided() { victim_.tally.accepted += outcomes().size(); }

  /// ROMA answers; then the next one is sent.
  void end(const Bytes &answer) {
    victim_.tally.genuine++;
    victim_.hear(answer);
    const std::vector<uint8_t> ended = outcomes();
    victim_.tally.lost += ended != std::vector<uint8_t>{1};
    victim_.board.radio.sent.clear();
    send();
  }

 private:
  void send() {
    victim_.board.transmit("ROMA", "SUPO", "tell;errand");
    packet_ = victim_.board.sendNext();
    const auto at = packet_.begin() + NONCE_AT;
    nonce_ = Bytes(at, at + javinolib::NONCE_LENGTH);
  }

  std::vector<uint8_t> outcomes() {
    std::vector<uint8_t> outcomes;
    for (const PollRecord &record : victim_.board.poll().records) {
      if (record.type == 'T') outcomes.push_back(record.value.at(1));
    }
    return outcomes;
  }

  Victim &victim_;
  Bytes packet_;
  Bytes nonce_;
};

std::string addressOf(const Bytes &nonce) {
  const unsigned bits = nonce[4] << 8 | nonce[5];
  return std::string("+K") + digit(bits >> 6) + digit(bits);
}

Bytes answer(const Bytes &nonce, const std::string &origin, const Bytes &message) {
  const unsigned bits = static_cast<unsigned>(message.size() * 8);
  return bytesOf(addressOf(nonce) + origin + digit(bits / 64) + digit(bits)) + message;
}

Bytes proof(const Bytes &key, Proof::Type type, const Bytes &nonce, const std::string &sender,
            const std::string &acknowledger, const Bytes &body) {
  javinolib::DerivedKeys keys;
  keys.derive(key.data());
  javinolib::Address to, from;
  javinolib::Address::parse(bytesOf(sender).data(), to);
  javinolib::Address::parse(bytesOf(acknowledger).data(), from);
  const Proof::Claim claim = {type, nonce.data(), to, from, body.data(), false};
  Bytes made(javinolib::PROOF_LENGTH);
  Proof(keys).make(claim, made.data());
  return made;
}

// ROMA's answer to a frame with this nonce.
Bytes genuine(Proof::Type type, const Bytes &nonce, const Bytes &body = Bytes()) {
  return answer(nonce, "ROMA", body + proof(Victim::pairKey(), type, nonce, "SUPO", "ROMA", body));
}

Bytes delivered(const Bytes &nonce) { return genuine(Proof::DELIVERED, nonce); }

Bytes raised(Bytes nonce, unsigned by) {
  unsigned counter = (nonce[3] << 16 | nonce[4] << 8 | nonce[5]) + by;
  for (int i = 5; i > 2; i--, counter >>= 8) nonce[i] = static_cast<uint8_t>(counter);
  return nonce;
}

// The acknowledgement that says: above this only.
Bytes stale(const Bytes &nonce, const Bytes &floor) { return genuine(Proof::STALE, nonce, floor + Bytes{0xFF, 0xFF}); }

// An acknowledgement as if it were of another frame.
Bytes readdressed(Bytes acknowledgement, const Bytes &nonce) {
  const std::string address = addressOf(nonce);
  std::copy(address.begin(), address.end(), acknowledgement.begin());
  return acknowledgement;
}

Bytes forged(const Bytes &nonce, RandomBytes &random) {
  static const uint8_t LENGTHS[] = {8, 9, 16};
  const Bytes key = Victim::pairKey();
  Bytes right = delivered(nonce);
  switch (random.number(8)) {
    case 0: return answer(nonce, "ROMA", random.bytes(random.number(67)));
    case 1:  // a bit of the right one
      right[random.number(static_cast<uint32_t>(right.size()))] ^= static_cast<uint8_t>(1 << random.number(8));
      return right;
    case 2:  // what proves something else
      return answer(nonce, "ROMA", proof(key, Proof::FRAGMENTS, nonce, "SUPO", "ROMA", {random.byte()}));
    case 3: return answer(nonce, "ROMA", proof(key, Proof::STALE, nonce, "SUPO", "ROMA", random.bytes(8)));
    case 4:  // the other way round
      return answer(nonce, "ROMA", proof(key, Proof::DELIVERED, nonce, "ROMA", "SUPO", {}));
    case 5:  // by another
      return answer(nonce, "SUPP", proof(key, Proof::DELIVERED, nonce, "SUPO", "SUPP", {}));
    case 6:  // under another key
      return answer(nonce, "ROMA", proof(Victim::groupKey(), Proof::DELIVERED, nonce, "SUPO", "ROMA", {}));
    default: return answer(nonce, "ROMA", random.bytes(LENGTHS[random.number(3)]));
  }
}

// Whether they differ in two bytes at most.
bool isNearly(const Bytes &one, const Bytes &other) {
  size_t differ = 0;
  for (size_t i = 0; i < one.size() && i < other.size(); i++) differ += one[i] != other[i];
  return one.size() == other.size() && differ <= 2;
}

}  // namespace

Tally forgeAcknowledgements(uint32_t seed, uint64_t tries) {
  Victim victim(seed);
  Errand errand(victim);
  return victim.endure(tries, [&] {
    for (int i = 0; i < 500; i++) victim.suffer(forged(errand.nonce(), victim.random));
    errand.checkUndecided();
    errand.end(delivered(errand.nonce()));
  });
}

// An acknowledgement nearly right, and then damaged, is a genuine one damaged a little more: it may be borne.
Tally forgeDamagedAcknowledgements(uint32_t seed, uint64_t tries) {
  Victim victim(seed);
  victim.board.radio.mends = true;
  Errand errand(victim);
  return victim.endure(tries, [&] {
    const Bytes right = delivered(errand.nonce());
    for (int i = 0; i < 30; i++) {
      Bytes guess = forged(errand.nonce(), victim.random);
      if (guess.size() == right.size() && victim.random.number(2) == 0)
        std::copy(right.begin(), right.begin() + HEADER, guess.begin());
      if (!isNearly(guess, right)) victim.suffer(guess, 0.03);
    }
    errand.checkUndecided();
    errand.end(right);
  });
}

Tally replayAcknowledgements(uint32_t seed, uint64_t tries) {
  Victim victim(seed);
  Errand errand(victim);
  std::vector<Bytes> recorded;
  return victim.endure(tries, [&] {
    for (const Bytes &earlier : recorded) {
      victim.suffer(earlier);
      victim.suffer(readdressed(earlier, errand.nonce()));
    }
    errand.checkUndecided();
    recorded.push_back(delivered(errand.nonce()));
    recorded.push_back(genuine(Proof::FRAGMENTS, errand.nonce(), {1}));
    if (recorded.size() > 200) recorded.erase(recorded.begin(), recorded.begin() + 2);
    errand.end(delivered(errand.nonce()));
  });
}

Tally raiseByMulticast(uint32_t seed, uint64_t tries) {
  Victim victim(seed);
  return victim.endure(tries, [&] {
    victim.board.transmit("//SU", "SUPO", "tell;group");
    const Bytes packet = victim.board.sendNext();
    const Bytes nonce(packet.begin() + NONCE_AT, packet.begin() + NONCE_AT + javinolib::NONCE_LENGTH);
    // A member who holds the key raises and raises.
    for (unsigned by = 1; by < 200; by++) {
      const Bytes body = raised(nonce, by) + Bytes{0xFF, 0xFF};
      const Bytes forged =
          answer(nonce, "SUXX", body + proof(Victim::groupKey(), Proof::STALE, nonce, "SUPO", "SUXX", body));
      victim.suffer(forged);
    }
    victim.board.sendNext();  // again, as a multicast is
    victim.board.radio.sent.clear();
    victim.board.poll();
    victim.tally.genuine++;
    victim.board.transmit("//SU", "SUPO", "tell;next");
    const Bytes next = victim.board.sendNext();
    const Bytes after(next.begin() + NONCE_AT, next.begin() + NONCE_AT + javinolib::NONCE_LENGTH);
    victim.tally.accepted += after > raised(nonce, 32);
    victim.tally.lost += after <= nonce;
    victim.board.sendNext();
    victim.board.radio.sent.clear();
    victim.board.poll();
  });
}

Tally forgeStaleAcknowledgements(uint32_t seed, uint64_t tries) {
  Victim victim(seed);
  Errand errand(victim);
  std::vector<Bytes> recorded;
  return victim.endure(tries, [&] {
    const Bytes nonce = errand.nonce();
    for (int i = 0; i < 100; i++) {
      const Bytes floor = raised(nonce, 1 + victim.random.number(31));
      Bytes forged = stale(nonce, floor);
      forged[HEADER + victim.random.number(16)] ^= static_cast<uint8_t>(1 + victim.random.number(255));
      victim.suffer(forged);
    }
    // Acknowledgements with a right proof even: of a floor that no receiver can have.
    victim.suffer(stale(nonce, raised(nonce, 34 + victim.random.number(1000000))));
    victim.suffer(stale(nonce, Bytes{0xFF, 0xFF, 0xFE} + Bytes(nonce.begin() + 3, nonce.end())));
    for (const Bytes &earlier : recorded) {
      victim.suffer(earlier);
      victim.suffer(readdressed(earlier, nonce));
    }
    errand.checkUndecided();
    victim.tally.accepted += errand.repeated() != errand.packet();
    recorded.push_back(stale(nonce, raised(nonce, 31)));
    if (recorded.size() > 100) recorded.erase(recorded.begin());
    errand.end(delivered(nonce));
    victim.tally.accepted += errand.nonce() != raised(nonce, 1);
  });
}
