// SPDX-License-Identifier: GPL-3.0-or-later
// CRC-16/X-25, which packets on the serial line and on the air end with (SPEC 4.1), low byte first.
#ifndef JAVINO_CRC_X25_H
#define JAVINO_CRC_X25_H

#include <stddef.h>
#include <stdint.h>

uint16_t crc_x25(const uint8_t *bytes, size_t length);

#endif
