#include "BootEpoch.h"

#include "../support/BigEndian.h"
#include "EepromLayout.h"

namespace javino {

const uint32_t BootEpoch::NONE_LEFT;

static EepromRecord recordAt(Eeprom &eeprom, uint8_t slot) {
  return EepromRecord(eeprom, static_cast<uint16_t>(EPOCHS_AT + slot * EPOCH_RECORD_LENGTH), EPOCH_LENGTH);
}

void BootEpoch::begin() {
  const uint8_t highest = findHighest();
  stored_ = false;
  if (value_ == NONE_LEFT) return;
  for (uint8_t i = 1; i <= config::EPOCH_SLOTS && !stored_; i++) {
    stored_ = store(static_cast<uint8_t>((highest + i) % config::EPOCH_SLOTS));
  }
}

// Sets the new value, and returns the place of the highest epoch stored so far.
uint8_t BootEpoch::findHighest() {
  uint32_t highest = 0;
  uint8_t slotOfHighest = config::EPOCH_SLOTS - 1;
  uint8_t unreadable = 0;
  for (uint8_t slot = 0; slot < config::EPOCH_SLOTS; slot++) {
    const EepromRecord record = recordAt(eeprom_, slot);
    uint8_t stored[EPOCH_LENGTH];
    if (record.read(stored)) {
      const uint32_t epoch = readUint24(stored);
      if (epoch < highest) continue;
      highest = epoch;
      slotOfHighest = slot;
    } else if (!record.isBlank()) {
      unreadable++;
    }
  }
  const uint32_t raised = highest + unreadable + 1;
  value_ = raised < NONE_LEFT ? raised : NONE_LEFT;
  return slotOfHighest;
}

bool BootEpoch::store(uint8_t slot) {
  uint8_t epoch[EPOCH_LENGTH];
  writeUint24(epoch, value_);
  return recordAt(eeprom_, slot).write(epoch);
}

}  // namespace javino
