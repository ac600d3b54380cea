#pragma once

#include <stdint.h>

namespace javinolib {

/// How long a radio's packets are on the air: what surrounds a payload, and each byte of it. They take no longer.
class AirRate {
 public:
  /// @param overheadMicros of preamble, sync word, header and CRC
  /// @param byteMicros of each byte of the packet
  AirRate(uint32_t overheadMicros, uint32_t byteMicros) : overheadMicros_(overheadMicros), byteMicros_(byteMicros) {}

  /// FSK or OOK: preamble, sync word, length and CRC count as 12 bytes.
  /// @param bitRate in bit/s, 300…500000
  static AirRate fsk(uint32_t bitRate) { return AirRate(12 * 8 * 1000000ul / bitRate, 8 * 1000000ul / bitRate); }

  /// LoRa with a preamble of 8 symbols, a header and a CRC.
  /// @param spreadingFactor 7…12
  /// @param bandwidth in Hz, 7800…500000
  /// @param codingRate 5…8 for 4/5…4/8
  static AirRate lora(uint8_t spreadingFactor, uint32_t bandwidth, uint8_t codingRate) {
    const uint32_t symbol = (1000000ul << spreadingFactor) / bandwidth;
    const uint8_t unused = symbol > 16000 ? 2 : 0;  // of the bits of a symbol: optimized for a low rate
    const uint8_t bits = static_cast<uint8_t>(spreadingFactor - unused);
    return AirRate(symbol * 81 / 4 + symbol * codingRate * static_cast<uint8_t>(11 - unused) / bits,
                   symbol * codingRate * 2 / bits);
  }

  uint32_t overheadMicros() const { return overheadMicros_; }

  /// @param bytes of a packet, all that a driver is given
  /// @return its time on the air in ms, at most 65535
  uint16_t millis(uint16_t bytes) const {
    const uint32_t millis = (overheadMicros_ + bytes * byteMicros_) / 1000 + 1;
    return millis > UINT16_MAX ? UINT16_MAX : static_cast<uint16_t>(millis);
  }

 private:
  uint32_t overheadMicros_;
  uint32_t byteMicros_;
};

}  // namespace javinolib
