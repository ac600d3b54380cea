#include "BootEpoch.h"

#include "../support/BigEndian.h"
#include "EepromLayout.h"

namespace javino {

const uint32_t BootEpoch::NONE_LEFT;

static const uint8_t COPIES = 2;

// One after the other they are now before the keys, now behind the floors.
JAVINO_NOINLINE static EepromRecord recordAt(uint8_t slot) {
  const uint16_t end = (slot & 1) == 0 ? EPOCHS_AT : OTHER_EPOCHS_AT;
  return EepromRecord(static_cast<uint16_t>(end + slot / 2 * EPOCH_RECORD_LENGTH), EPOCH_LENGTH);
}

static uint8_t behind(uint8_t slot, uint8_t count) { return static_cast<uint8_t>((slot + count) % config::EPOCH_SLOTS); }

// Behind the highest are the two oldest, of which a loss of power may have torn one. Where neither can be read, something
// else has written there, perhaps over a higher epoch.
JAVINO_NOINLINE static bool isBroken(uint8_t highest) {
  uint8_t stored[EPOCH_LENGTH];
  return !recordAt(behind(highest, 1)).read(stored) && !recordAt(behind(highest, 2)).read(stored);
}

void BootEpoch::begin(bool hasKeys) {
  const uint8_t highest = findHighest();
  if (hasKeys && isBroken(highest)) {
    value_ = 0;
    status_ = Status::EPOCH_LOST;
  } else {
    store(highest, value_ == NONE_LEFT ? NONE_LEFT : value_ + 1);
  }
}

// Sets the value to the highest epoch stored so far, 0 where there is none, and returns its place.
uint8_t BootEpoch::findHighest() {
  uint8_t slotOfHighest = config::EPOCH_SLOTS - 1;
  value_ = 0;
  for (uint8_t slot = 0; slot < config::EPOCH_SLOTS; slot++) {
    uint8_t stored[EPOCH_LENGTH];
    if (!recordAt(slot).begin(stored, 0) || readUint24(stored) < value_) continue;
    value_ = readUint24(stored);
    slotOfHighest = slot;
  }
  return slotOfHighest;
}

// Goes on with an epoch, and writes it behind the place of the highest so far; into all other places of a broken ring.
void BootEpoch::store(uint8_t highest, uint32_t epoch) {
  const uint8_t wanted = isBroken(highest) ? config::EPOCH_SLOTS : COPIES;
  uint8_t record[EPOCH_LENGTH];
  writeUint24(record, epoch);
  value_ = epoch;
  uint8_t copies = 0;
  for (uint8_t i = 1; i < config::EPOCH_SLOTS && copies < wanted && epoch != NONE_LEFT; i++) {
    if (recordAt(behind(highest, i)).write(record)) copies++;
  }
  status_ = epoch == NONE_LEFT ? Status::NONCE_EXHAUSTED : copies >= COPIES ? Status::OK : Status::STORE_FAILED;
}

}  // namespace javino
