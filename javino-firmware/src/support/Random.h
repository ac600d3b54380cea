#pragma once

#include <stdint.h>

#include "BigEndian.h"
#include "Inlining.h"

namespace javinolib {

/// Random numbers for back-off, not for secrets: xorshift of 16 bits, whose period is 65535. Each board's begin from its
/// RF id and boot epoch (SPEC 7.4), so that two boards that met once do not meet again and again.
class Random {
 public:
  Random() : state_(1) {}

  /// @param id 24 bits
  /// @param epoch 24 bits
  void seed(Uint24 id, Uint24 epoch);

  /// @param mask 0, 1, 3, 7, … 0xFFFF
  /// @return a number 0…mask, all of them equally likely
  JAVINO_NOINLINE uint16_t next(uint16_t mask);

 private:
  uint16_t state_;  // never 0
};

}  // namespace javinolib
