#pragma once

#include <stdint.h>

#include "../Config.h"
#include "../addressing/Address.h"
#include "../crypto/DerivedKeys.h"
#include "EepromRecord.h"

#if defined(__AVR__)
#include <avr/io.h>
#endif

namespace javino {

/// Where things are in EEPROM: RF id, ring of boot epochs, keys, in this order.

static const uint8_t EPOCH_LENGTH = 3;
static const uint8_t EPOCH_RECORD_LENGTH = EPOCH_LENGTH + EepromRecord::CHECK_LENGTH;
static const uint8_t RF_ID_RECORD_LENGTH = Address::STORED_LENGTH + EepromRecord::CHECK_LENGTH;
static const uint8_t KEY_LENGTH = 2 * Aes128::KEY_LENGTH + DerivedKeys::CHECK_LENGTH + Address::STORED_LENGTH;
static const uint8_t KEY_RECORD_LENGTH = KEY_LENGTH + EepromRecord::CHECK_LENGTH;

static const uint16_t RF_ID_AT = config::EEPROM_START;
static const uint16_t EPOCHS_AT = RF_ID_AT + RF_ID_RECORD_LENGTH;
static const uint16_t KEYS_AT = EPOCHS_AT + config::EPOCH_SLOTS * EPOCH_RECORD_LENGTH;

/// The first byte that is free for the sketch.
static const uint16_t EEPROM_END = KEYS_AT + config::KEYS * KEY_RECORD_LENGTH;

#if defined(E2END)
static_assert(EEPROM_END <= E2END + 1, "The keys and epochs of Config.h do not fit the EEPROM of this chip");
#endif

}  // namespace javino
