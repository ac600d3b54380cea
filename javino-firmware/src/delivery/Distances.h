#pragma once

#include <stdint.h>

#include "../radio/Radio.h"

namespace javinolib {

/// A relay's knowledge of addresses (SPEC 7.5): how far each is, and the score, how far copies are needed by packets to it: 0
/// where they have brought one on, 3 where they have not. Those that were longest unchanged are forgotten. Zeros are none.
class Distances {
 public:
  static const uint8_t NONE = 0;
  static const uint8_t FIRST = 1;
  static const uint8_t AFTER_RESERVE = 2;
  static const uint8_t MOST = 3;

  /// An address by a number that most others do not have.
  static uint16_t numberOf(const uint8_t *text);

  /// The score, 0…3.
  uint8_t scoreOf(uint16_t address) const { return of(address) & SCORE_MASK; }
  void setScore(uint16_t address, uint8_t score);

  /// One more than the distance modulo 4; 0 where that is unknown.
  uint8_t to(uint16_t address) const { return distanceIn(of(address)); }

  /// A packet came from this address.
  /// @param hops behind it, modulo 4
  void heard(uint16_t address, uint8_t hops);

 private:
  static const uint8_t CAPACITY = 32;
  static const uint8_t SCORE_MASK = 3;
  static const uint8_t DISTANCE_SHIFT = 2;
  static const uint8_t DISTANCE_MASK = 7;
  static const uint8_t FARTHER_SHIFT = 5;
  static const uint8_t MOST_FARTHER = 3;

  struct Entry {
    uint16_t address;
    uint8_t known;  // the score, the distance, and how often in a row a greater one was heard
  };

  static uint8_t distanceIn(uint8_t known) { return (known >> DISTANCE_SHIFT) & DISTANCE_MASK; }
  uint8_t find(uint16_t address) const;
  uint8_t of(uint16_t address) const;
  void set(uint16_t address, uint8_t known);

  uint8_t count_;
  Entry entries_[CAPACITY];  // the one that was changed last is the first
};

}  // namespace javinolib
