#pragma once

#include <stdint.h>

namespace javino {

/// An address on the air or on the serial line: four Base64 digits, 24 bits (SPEC 1).
class Address {
 public:
  static const uint8_t TEXT_LENGTH = 4;
  static const uint8_t STORED_LENGTH = 3;

  enum Class : uint8_t { DEVICE, SERIAL_LINE, BROADCAST, MULTICAST, RESERVED };

  /// The serial line's address, `++++`; as an RF id it means that none is set.
  Address() : value_(SERIAL_VALUE) {}

  /// @param value 0…0xFFFFFF
  explicit Address(uint32_t value) : value_(value & 0xFFFFFF) {}

  /// Reads four digits.
  /// @return false, and `into` is untouched, where one is outside the alphabet.
  static bool parse(const uint8_t *text, Address &into);

  /// Writes the four digits.
  void write(uint8_t *text) const;

  Class classOf() const;
  bool isDevice() const { return classOf() == DEVICE; }
  bool isSerial() const { return value_ == SERIAL_VALUE; }
  bool isBroadcast() const { return value_ == 0xFFFFFF; }
  bool isMulticast() const { return classOf() == MULTICAST; }

  /// All 24 bits.
  uint32_t value() const { return value_; }

  /// The first two digits, 12 bits.
  uint16_t group() const { return static_cast<uint16_t>(value_ >> 12); }

  /// The last two digits, 12 bits; of a multicast address, the group that it is for.
  uint16_t member() const { return static_cast<uint16_t>(value_ & 0xFFF); }

  bool operator==(const Address &other) const { return value_ == other.value_; }
  bool operator!=(const Address &other) const { return value_ != other.value_; }

 private:
  static const uint32_t SERIAL_VALUE = 0xFBEFBE;

  uint32_t value_;
};

}  // namespace javino
