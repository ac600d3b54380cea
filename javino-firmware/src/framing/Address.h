#pragma once

#include <stdint.h>
#include <string.h>

#include "../support/BigEndian.h"
#include "../support/Inlining.h"

namespace javinolib {

/// The value that base64Value() gives for a byte outside the alphabet.
static const uint8_t NOT_A_DIGIT = 0xFF;

/// @return the value 0…63 of a Base64 digit (RFC 4648 section 4: `A`…`Z`, `a`…`z`, `0`…`9`, `+`, `/`), or NOT_A_DIGIT.
uint8_t base64Value(uint8_t digit);

/// @param value 0…63
uint8_t base64Digit(uint8_t value);

/// An address on the air or on the serial line: four Base64 digits, 24 bits (SPEC 1).
class Address {
 public:
  static const uint8_t TEXT_LENGTH = 4;
  static const uint8_t STORED_LENGTH = 3;

  enum Kind : uint8_t { DEVICE, SERIAL_LINE, BROADCAST, MULTICAST, FRAGMENT, ACKNOWLEDGEMENT, RESERVED };

  /// Any address, to be assigned before use. No constructor: those of all the addresses that a board holds would cost
  /// 228 bytes of flash.
  Address() = default;

  /// The serial line's address, `++++`; as an RF id it means that none is set.
  static Address serialLine() { return Address(PLUSES, PLUSES); }

  /// All in range, `////`.
  static Address broadcast() { return Address(SLASHES, SLASHES); }

  /// A fragment's address: `+F` and these two digits (SPEC 7.1).
  /// @param id 0…63
  /// @param index 0…63
  static Address fragment(uint8_t id, uint8_t index) {
    return Address(FRAGMENTS, static_cast<uint16_t>(id << 6 | index));
  }

  /// An acknowledgement's address: `+K` and these 12 bits as two digits (SPEC 7.3).
  static Address acknowledgement(uint16_t bits) { return Address(ACKNOWLEDGEMENTS, bits); }

  /// @param value 0…0xFFFFFF
  explicit Address(uint32_t value) { writeUint24(bytes_, value); }

  /// Reads what store() wrote.
  /// @param bytes 3 bytes
  static Address stored(const uint8_t *bytes) { return *reinterpret_cast<const Address *>(bytes); }

  /// Writes all 24 bits, the highest first.
  /// @param into room for 3 bytes
  void store(uint8_t *into) const { memcpy(into, bytes_, sizeof bytes_); }

  /// Reads four digits.
  /// @return false, and `into` is untouched, where one is outside the alphabet.
  JAVINO_NOINLINE static bool parse(const uint8_t *text, Address &into);

  /// Writes the four digits.
  JAVINO_NOINLINE void write(uint8_t *text) const;

  JAVINO_NOINLINE Kind kind() const;
  bool isDevice() const { return kind() == DEVICE; }
  bool isSerial() const { return kind() == SERIAL_LINE; }
  bool isBroadcast() const { return kind() == BROADCAST; }
  bool isMulticast() const { return kind() == MULTICAST; }

  /// All 24 bits.
  Uint24 value() const { return readUint24(bytes_); }

  /// The first two digits, 12 bits.
  uint16_t group() const { return static_cast<uint16_t>(bytes_[0] << 4 | bytes_[1] >> 4); }

  /// The last two digits, 12 bits; of a multicast address, the group that it is for.
  uint16_t member() const { return static_cast<uint16_t>((bytes_[1] & 0x0F) << 8 | bytes_[2]); }

  JAVINO_NOINLINE bool operator==(const Address &other) const;
  bool operator!=(const Address &other) const { return !(*this == other); }

 private:
  static const uint8_t FIRST_PLUS = 0xF8;          // `+A`: the first byte that is no device's
  static const uint16_t FRAGMENTS = 0xF85;         // `+F`
  static const uint16_t ACKNOWLEDGEMENTS = 0xF8A;  // `+K`
  static const uint16_t PLUSES = 0xFBE;            // `++`
  static const uint16_t SLASHES = 0xFFF;           // `//`

  Address(uint16_t group, uint16_t member)
      : bytes_{static_cast<uint8_t>(group >> 4), static_cast<uint8_t>(group << 4 | member >> 8),
               static_cast<uint8_t>(member)} {}

  uint8_t bytes_[STORED_LENGTH];  // as EEPROM has it
};

}  // namespace javinolib
