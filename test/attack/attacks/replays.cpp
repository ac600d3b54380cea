// Genuine frames that are heard again.

#include "attacks/attacks.h"
#include "support/Victim.h"

namespace {

const uint32_t RAISE = 32;  // by which a sender goes above a floor
const size_t MOST_RECORDED = 300;

/// The frames that were on the air, for whoever listened.
class Recording {
 public:
  explicit Recording(Victim &victim) : victim_(victim) {}

  const Bytes &next() {
    if (frames_.size() == MOST_RECORDED) frames_.erase(frames_.begin());
    frames_.push_back(victim_.genuine(8 + victim_.random.number(46), victim_.random.number(3) == 0));
    return frames_.back();
  }

  void replayAll() {
    for (const Bytes &frame : frames_) {
      victim_.suffer(frame);
      victim_.take();
    }
  }

  void replayAny() { victim_.suffer(frames_[victim_.random.number(static_cast<uint32_t>(frames_.size()))]); }

 private:
  Victim &victim_;
  std::vector<Bytes> frames_;
};

/// Messages that are delivered, and one that waits for the host when the board is reset.
void exchange(Victim &victim, Recording &recording) {
  for (uint32_t left = 1 + victim.random.number(40); left > 0; left--) victim.deliver(recording.next());
  const Bytes waiting = recording.next();
  victim.allow(waiting);
  victim.hear(waiting);
}

Tally replayAcross(bool keepsRam, uint32_t seed, uint64_t tries) {
  Victim victim(seed);
  Recording recording(victim);
  victim.endure(tries, [&] {
    exchange(victim, recording);
    victim.reset(keepsRam);
    recording.replayAll();
    victim.disallow();
    recording.replayAll();
    if (!keepsRam) victim.raiseCounter(RAISE);
  });
  victim.deliver(recording.next());
  return victim.tally;
}

// Power fails at one of the next EEPROM writes: while messages come, or while the board starts.
void cutPower(Victim &victim, Recording &recording) {
  victim.board.eeprom.cutPowerAfter(static_cast<int>(victim.random.number(60)), victim.random.byte());
  try {
    for (uint32_t left = victim.random.number(100); left > 0; left--) {
      const Bytes frame = recording.next();
      victim.allow(frame);
      victim.hear(frame);
      victim.take();
    }
    victim.board.powerUp();
  } catch (const PowerCut &) {
  }
}

}  // namespace

Tally replayWithinABoot(uint32_t seed, uint64_t tries) {
  Victim victim(seed);
  Recording recording(victim);
  return victim.endure(tries, [&] {
    victim.deliver(recording.next());
    const Bytes waiting = recording.next();
    victim.allow(waiting);
    for (int i = 0; i < 5; i++) victim.suffer(waiting);
    victim.take();
    for (int i = 0; i < 100; i++) recording.replayAny();
    victim.take();
  });
}

// The origins are invented before ROMA has said anything.
Tally inventOrigins(uint32_t seed, uint64_t tries) {
  Tally sum;
  for (uint32_t round = 0; sum.tries < tries; round++) {
    Victim victim(seed + round);
    victim.board.setKey("SUPP", Victim::groupKey());
    for (uint32_t i = 0; i < 500; i++) {
      std::string origin = "M";
      for (int k = 0; k < 3; k++) origin += digit(victim.random.number(64));
      const Bytes frame =
          sealed(Victim::groupKey(), "//SU", origin, {0, 0, 1, 0, 0, 1}, "invented " + std::to_string(i));
      victim.allow(frame);
      victim.suffer(frame);
      victim.take();
      if (i % 200 == 100) victim.reset(false);
    }
    victim.deliver(victim.genuine(16, false));
    const Bytes fromSupp = sealed(Victim::groupKey(), "SUPO", "SUPP", {0, 0, 1, 0, 0, 1}, "errand of SUPP");
    victim.allow(fromSupp);
    victim.tally.genuine++;
    victim.hear(fromSupp);
    victim.tally.lost += victim.board.messages().empty();
    sum.tries += victim.tally.tries;
    sum.accepted += victim.tally.accepted;
    sum.genuine += victim.tally.genuine;
    sum.lost += victim.tally.lost;
  }
  return sum;
}

Tally replayAcrossResets(uint32_t seed, uint64_t tries) { return replayAcross(true, seed, tries); }

Tally replayAcrossPowerLoss(uint32_t seed, uint64_t tries) { return replayAcross(false, seed, tries); }

Tally replayAcrossCutWrites(uint32_t seed, uint64_t tries) {
  Victim victim(seed);
  Recording recording(victim);
  return victim.endure(tries, [&] {
    cutPower(victim, recording);
    victim.reset(false);
    recording.replayAll();  // what came as power failed may come once
    victim.disallow();
    recording.replayAll();
    victim.raiseCounter(RAISE);
    victim.deliver(recording.next());
  });
}
