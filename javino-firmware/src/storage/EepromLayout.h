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

/// The library's part lies at the end of the EEPROM, so that the low addresses are the sketch's: RF id, ring of boot epochs, keys,
/// ring of nonces' floors, whether the board relays, the other half of the ring of boot epochs. No byte has a meaning but in a
/// record with a seal: whatever stands there, nobody writes to the sketch's part.

#ifdef MAPPED_EEPROM_SIZE  // where the EEPROM is among the other addresses, E2END is not its length
static const uint16_t CHIPS_EEPROM = MAPPED_EEPROM_SIZE;
#elif defined(E2END)
static const uint16_t CHIPS_EEPROM = E2END + 1;
#else
static const uint16_t CHIPS_EEPROM = JAVINO_BY_PROFILE(4096, 1024);
#endif

/// Whether a board with a radio has room for its keys; without, ArduinoBoard.h lets none be made.
static const bool EEPROM_SUFFICES = CHIPS_EEPROM >= JAVINO_BY_PROFILE(4096, 1024);
static const uint16_t LAYOUT_END = EEPROM_SUFFICES ? CHIPS_EEPROM : JAVINO_BY_PROFILE(4096, 1024);

/// Address and generation.
static const uint8_t RF_ID_LENGTH = Address::STORED_LENGTH + 1;
static const uint8_t RF_ID_RECORD_LENGTH = RF_ID_LENGTH + EepromRecord::CHECK_LENGTH;
static const uint8_t RF_ID_PLACES = 2;

static const uint8_t EPOCH_LENGTH = 3;
static const uint8_t EPOCH_RECORD_LENGTH = EPOCH_LENGTH + EepromRecord::CHECK_LENGTH;
static const uint16_t EPOCHS_LENGTH = config::EPOCH_SLOTS / 2 * EPOCH_RECORD_LENGTH;

/// Address, generation, whether it replaces all older ones, check value, Kenc and Kmac.
static const uint8_t KEY_LENGTH = Address::STORED_LENGTH + 1 + 1 + DerivedKeys::CHECK_LENGTH + 2 * Aes128::KEY_LENGTH;
static const uint8_t KEY_RECORD_LENGTH = KEY_LENGTH + EepromRecord::CHECK_LENGTH;

/// The record, and whether it was taken into use.
static const uint8_t KEY_PLACE_LENGTH = KEY_RECORD_LENGTH + 1;
static const uint8_t KEY_PLACES = config::KEYS + 1;

/// Place of the key, origin and nonce. Each place of the ring has two copies, one behind the other.
static const uint8_t FLOOR_LENGTH = 1 + Address::STORED_LENGTH + NONCE_LENGTH;
static const uint8_t FLOOR_RECORD_LENGTH = FLOOR_LENGTH + EepromRecord::CHECK_LENGTH;
static const uint8_t FLOOR_COPIES = 2;
static const uint8_t FLOOR_PLACE_LENGTH = FLOOR_COPIES * FLOOR_RECORD_LENGTH;

/// A record that is there while the board relays: a number from which its random ones begin if it has no RF id.
static const uint8_t RELAYING_LENGTH = 2;
static const uint8_t RELAYING_RECORD_LENGTH = config::LARGE ? RELAYING_LENGTH + EepromRecord::CHECK_LENGTH : 0;

static const uint16_t OTHER_EPOCHS_AT = LAYOUT_END - EPOCHS_LENGTH;
static const uint16_t RELAYING_AT = OTHER_EPOCHS_AT - RELAYING_RECORD_LENGTH;
static const uint16_t FLOORS_AT = RELAYING_AT - config::FLOOR_SLOTS * FLOOR_PLACE_LENGTH;
static const uint16_t KEYS_AT = FLOORS_AT - KEY_PLACES * KEY_PLACE_LENGTH;
static const uint16_t EPOCHS_AT = KEYS_AT - EPOCHS_LENGTH;
static const uint16_t RF_ID_AT = EPOCHS_AT - RF_ID_PLACES * RF_ID_RECORD_LENGTH;

static_assert(RF_ID_AT >= JAVINO_BY_PROFILE(512, 128) && RF_ID_AT < LAYOUT_END,
              "JAVINO_KEYS: so many leave too little of the EEPROM to the sketch");

}  // namespace javinolib
