// SPDX-License-Identifier: GPL-3.0-or-later
// Intel HEX (Hexadecimal Object File Format Specification, revision A, 1988), as avr-objcopy writes it.
#ifndef JAVINO_INTEL_HEX_H
#define JAVINO_INTEL_HEX_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

// A part of a memory that a file may fill, and what of it one has filled: lowest…end - 1.
typedef struct {
  uint8_t *memory;
  uint32_t first, limit;
  uint32_t lowest, end;
} hex_target;

// Whether bytes begin as such a file does.
bool intel_hex_begins(const uint8_t *bytes, size_t length);

// Copies all data to where they belong. False if a record is damaged, is missing, has no end behind it, or belongs elsewhere,
// and if there is none; some of the data may have been copied then.
bool intel_hex_copy(const uint8_t *bytes, size_t length, hex_target *target);

#endif
