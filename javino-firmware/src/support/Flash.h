#pragma once

#include <stdint.h>

#include "CoreTypes.h"

/// Constants that stay in flash on AVR, and are plain constants elsewhere.
#ifdef __AVR__
#include <avr/pgmspace.h>
// Before those of others, in the room that the S-box of AES leaves before it (Aes128Avr.S, Aes128AvrSmall.S).
#define JAVINO_FLASH __attribute__((section(".progmem.gcc_javino")))
#else
#define JAVINO_FLASH
#endif

namespace javinolib {

/// Arduino's type of F("…") texts.
typedef __FlashStringHelper FlashText;

/// Reads one byte of a constant that was declared with JAVINO_FLASH, or of an F("…"), which other chips may keep in flash too.
inline uint8_t flashByte(const uint8_t *at) {
#ifdef pgm_read_byte
  return pgm_read_byte(at);
#else
  return *at;
#endif
}

/// Reads a number of 16 bits that was declared with JAVINO_FLASH.
inline uint16_t flashWord(const uint16_t *at) {
#ifdef __AVR__
  return pgm_read_word(at);
#else
  return *at;
#endif
}

/// Reads character `index` of a text in flash; 0 is its end.
inline char flashChar(const FlashText *text, uint16_t index) {
  return static_cast<char>(flashByte(reinterpret_cast<const uint8_t *>(text) + index));
}

}  // namespace javinolib
