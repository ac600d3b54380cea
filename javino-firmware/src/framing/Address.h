#pragma once

#include <stdint.h>

#include "../support/Inlining.h"

namespace javinolib {

/// What base64Value() gives for a byte outside the alphabet.
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

  enum Class : uint8_t { DEVICE, SERIAL_LINE, BROADCAST, MULTICAST, PIECE, ACKNOWLEDGEMENT, RESERVED };

  /// Any address, to be assigned before use. No constructor: those of all the addresses that a board holds would cost
  /// 228 bytes of flash.
  Address() = default;

  /// The serial line's address, `++++`; as an RF id it means that none is set.
  static Address serialLine() { return Address(PLUSES, PLUSES); }

  /// All in range, `////`.
  static Address broadcast() { return Address(SLASHES, SLASHES); }

  /// A piece's address: `+F` and these two digits (SPEC 7.1).
  /// @param id 0…63
  /// @param index 0…63
  static Address piece(uint8_t id, uint8_t index) { return Address(PIECES, static_cast<uint16_t>(id << 6 | index)); }

  /// An acknowledgement's address: `+K` and these 12 bits as two digits (SPEC 7.3).
  static Address acknowledgement(uint16_t bits) { return Address(ACKNOWLEDGEMENTS, bits); }

  /// @param value 0…0xFFFFFF
  explicit Address(uint32_t value) : Address(value >> 12 & 0xFFF, value & 0xFFF) {}

  /// Reads what store() wrote.
  /// @param bytes 3 bytes
  JAVINO_OUT_OF_LINE static Address stored(const uint8_t *bytes);

  /// Writes all 24 bits, the highest first.
  /// @param into room for 3 bytes
  JAVINO_OUT_OF_LINE void store(uint8_t *into) const;

  /// Reads four digits.
  /// @return false, and `into` is untouched, where one is outside the alphabet.
  JAVINO_NOINLINE static bool parse(const uint8_t *text, Address &into);

  /// Writes the four digits.
  JAVINO_NOINLINE void write(uint8_t *text) const;

  JAVINO_NOINLINE Class classOf() const;
  bool isDevice() const { return classOf() == DEVICE; }
  bool isSerial() const { return classOf() == SERIAL_LINE; }
  bool isBroadcast() const { return classOf() == BROADCAST; }
  bool isMulticast() const { return classOf() == MULTICAST; }

  /// All 24 bits.
  uint32_t value() const { return static_cast<uint32_t>(group_) << 12 | member_; }

  /// The first two digits, 12 bits.
  uint16_t group() const { return group_; }

  /// The last two digits, 12 bits; of a multicast address, the group that it is for.
  uint16_t member() const { return member_; }

  JAVINO_NOINLINE bool operator==(const Address &other) const;
  bool operator!=(const Address &other) const { return !(*this == other); }

 private:
  static const uint16_t FIRST_PLUS = 0xF80;        // `+A`, the first group that is no device's
  static const uint16_t PIECES = 0xF85;            // `+F`
  static const uint16_t ACKNOWLEDGEMENTS = 0xF8A;  // `+K`
  static const uint16_t PLUSES = 0xFBE;            // `++`
  static const uint16_t SLASHES = 0xFFF;           // `//`

  Address(uint16_t group, uint16_t member) : group_(group), member_(member) {}

  uint16_t group_;
  uint16_t member_;
};

}  // namespace javinolib
