// SPDX-License-Identifier: GPL-3.0-or-later
#include "utf8.h"

// How many continuation bytes follow `first`, or -1 where no character begins with it.
static int continuation_count(uint8_t first) {
  if (first < 0x80) return 0;
  if (first >= 0xC2 && first <= 0xDF) return 1;
  if (first >= 0xE0 && first <= 0xEF) return 2;
  if (first >= 0xF0 && first <= 0xF4) return 3;
  return -1;
}

// Some first bytes narrow the range of the second (RFC 3629 section 4).
static bool second_allowed(uint8_t first, uint8_t second) {
  switch (first) {
    case 0xE0: return second >= 0xA0;
    case 0xED: return second <= 0x9F;
    case 0xF0: return second >= 0x90;
    case 0xF4: return second <= 0x8F;
    default: return true;
  }
}

bool utf8_valid(const uint8_t *bytes, size_t length) {
  size_t at = 0;
  while (at < length) {
    uint8_t first = bytes[at++];
    int more = continuation_count(first);
    if (more < 0 || (size_t)more > length - at) return false;
    if (more > 0 && !second_allowed(first, bytes[at])) return false;
    for (; more > 0; more--)
      if ((bytes[at++] & 0xC0) != 0x80) return false;
  }
  return true;
}
