// SPDX-License-Identifier: GPL-3.0-or-later
#include "crc_x25.h"

uint16_t crc_x25(const uint8_t *bytes, size_t length) {
  uint16_t crc = 0xFFFF;
  for (size_t i = 0; i < length; i++) {
    crc ^= bytes[i];
    for (int bit = 0; bit < 8; bit++) crc = (uint16_t)(crc & 1 ? crc >> 1 ^ 0x8408 : crc >> 1);
  }
  return (uint16_t)~crc;
}
