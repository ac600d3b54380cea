#include "BootEpoch.h"

#include "../support/Trace.h"
#include "EepromLayout.h"

namespace javinolib {

const Uint24 BootEpoch::NONE_LEFT;

static const uint8_t COPIES = 2;

// One after the other they are now before the keys, now behind the floors.
JAVINO_NOINLINE static uint16_t placeAt(uint8_t slot) {
  const uint16_t end = (slot & 1) == 0 ? EPOCHS_AT : OTHER_EPOCHS_AT;
  return static_cast<uint16_t>(end + slot / 2 * EPOCH_RECORD_LENGTH);
}

static EepromRecord recordAt(uint8_t slot) { return EepromRecord(placeAt(slot), EPOCH_LENGTH); }

static uint8_t behind(uint8_t slot) {
  return static_cast<uint8_t>(static_cast<uint8_t>(slot + 1) % config::EPOCH_SLOTS);
}

void BootEpoch::begin(bool hasKeys) {
  const uint8_t highest = findHighest();
  if (status_ == Status::EPOCH_LOST && hasKeys) {
    value_ = 0;
  } else {
    store(highest, value_ == NONE_LEFT ? NONE_LEFT : value_ + 1);
  }
}

// Sets the value to the highest epoch stored so far, 0 where there is none, and returns its place. Behind it are the two
// oldest, of which a loss of power may have torn one. Where neither can be read, something else has written there, perhaps
// over a higher epoch: it is lost.
uint8_t BootEpoch::findHighest() {
  uint8_t slotOfHighest = config::EPOCH_SLOTS - 1;
  uint8_t since = 0;
  uint8_t broken = 0;
  Uint24 highest = 0;
  for (uint8_t i = 0; i < config::EPOCH_SLOTS + COPIES; i++) {
    uint8_t stored[EPOCH_RECORD_LENGTH];
    const bool whole = recordAt(i % config::EPOCH_SLOTS).begin(stored, 0);
    const Uint24 epoch = readUint24(stored);
    if (i < config::EPOCH_SLOTS && whole && epoch >= highest) {
      highest = epoch;
      slotOfHighest = i;
      since = 0;
      broken = 0;
    } else if (++since <= COPIES && !whole) {
      broken++;
    }
  }
  value_ = highest;
  status_ = broken == COPIES ? Status::EPOCH_LOST : Status::OK;
  return slotOfHighest;
}

// Goes on with an epoch, and writes it behind the place of the highest so far; into all other places where one is lost.
void BootEpoch::store(uint8_t highest, Uint24 epoch) {
  const bool lost = status_ == Status::EPOCH_LOST;
  value_ = epoch;
  status_ = Status::NONCE_EXHAUSTED;
  if (epoch == NONE_LEFT) return;
  status_ = Status::STORE_FAILED;
  uint8_t record[EPOCH_RECORD_LENGTH];
  writeUint24(record, epoch);
  uint8_t copies = 0;
  for (uint8_t slot = highest; (slot = behind(slot)) != highest && (lost || copies < COPIES);) {
    if (recordAt(slot).write(record)) copies++;
  }
  if (copies < COPIES) return;
  status_ = Status::OK;
  trace::tell(trace::EPOCH_STORED, record[EPOCH_LENGTH - 1]);
}

}  // namespace javinolib
