#pragma once

#include <stdint.h>

#include "../Config.h"
#include "../framing/Address.h"
#include "../crypto/DerivedKeys.h"
#include "../framing/Limits.h"
#include "EepromRecord.h"

#if defined(__AVR__)
#include <avr/io.h>
#endif

namespace javinolib {

/// Where things are in EEPROM, in this order: RF id, ring of boot epochs, keys, ring of nonces' floors, whether the board
/// relays, the other half of the ring of boot epochs.

/// Address and generation.
static const uint8_t RF_ID_LENGTH = Address::STORED_LENGTH + 1;
static const uint8_t RF_ID_RECORD_LENGTH = RF_ID_LENGTH + EepromRecord::CHECK_LENGTH;
static const uint8_t RF_ID_PLACES = 2;

static const uint8_t EPOCH_LENGTH = 3;
static const uint8_t EPOCH_RECORD_LENGTH = EPOCH_LENGTH + EepromRecord::CHECK_LENGTH;
static const uint16_t EPOCHS_LENGTH = config::EPOCH_SLOTS / 2 * EPOCH_RECORD_LENGTH;

/// Kenc, Kmac, check value, address, generation, and whether it replaces all older ones.
static const uint8_t KEY_LENGTH = 2 * Aes128::KEY_LENGTH + DerivedKeys::CHECK_LENGTH + Address::STORED_LENGTH + 1 + 1;
static const uint8_t KEY_RECORD_LENGTH = KEY_LENGTH + EepromRecord::CHECK_LENGTH;

/// The record, and whether it was taken into use.
static const uint8_t KEY_PLACE_LENGTH = KEY_RECORD_LENGTH + 1;
static const uint8_t KEY_PLACES = config::KEYS + 1;

/// Place of the key, origin and nonce. Each place of the ring has two copies, one behind the other.
static const uint8_t FLOOR_LENGTH = 1 + Address::STORED_LENGTH + NONCE_LENGTH;
static const uint8_t FLOOR_RECORD_LENGTH = FLOOR_LENGTH + EepromRecord::CHECK_LENGTH;
static const uint8_t FLOOR_COPIES = 2;
static const uint8_t FLOOR_PLACE_LENGTH = FLOOR_COPIES * FLOOR_RECORD_LENGTH;

static const uint16_t RF_ID_AT = config::EEPROM_START;
static const uint16_t EPOCHS_AT = RF_ID_AT + RF_ID_PLACES * RF_ID_RECORD_LENGTH;
static const uint16_t KEYS_AT = EPOCHS_AT + EPOCHS_LENGTH;
static const uint16_t FLOORS_AT = KEYS_AT + KEY_PLACES * KEY_PLACE_LENGTH;

static const uint16_t RELAYING_AT = FLOORS_AT + config::FLOOR_SLOTS * FLOOR_PLACE_LENGTH;

/// A record that is there while the board relays: a number from which its random ones begin if it has no RF id.
static const uint8_t RELAYING_LENGTH = 2;

static const uint16_t OTHER_EPOCHS_AT =
    RELAYING_AT + (config::RELAY ? RELAYING_LENGTH + EepromRecord::CHECK_LENGTH : 0);

/// The first byte that is free for the sketch.
static const uint16_t EEPROM_END = OTHER_EPOCHS_AT + EPOCHS_LENGTH;

#if defined(E2END)
static_assert(EEPROM_END <= E2END + 1, "The keys, epochs and floors of Config.h do not fit the EEPROM of this chip");
#endif

}  // namespace javinolib
