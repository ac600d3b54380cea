// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef JAVINO_HEX_H
#define JAVINO_HEX_H

#include <stddef.h>
#include <stdint.h>

// The value of a hexadecimal digit, or -1 for another character.
int hex_digit(char c);

// Reads bytes in hexadecimal digits. Returns their number, or -1 where the text is NULL or no such text, or has more than
// `size` bytes.
int hex_read(uint8_t *bytes, size_t size, const char *text);

#endif
