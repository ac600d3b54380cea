// SPDX-License-Identifier: GPL-3.0-or-later
#include "hex.h"

#include <string.h>

int hex_digit(char c) {
  static const char DIGITS[] = "0123456789abcdef";
  const char *found = c ? strchr(DIGITS, c >= 'A' && c <= 'F' ? c - 'A' + 'a' : c) : NULL;
  return found ? (int)(found - DIGITS) : -1;
}

int hex_read(uint8_t *bytes, size_t size, const char *text) {
  size_t length = text ? strlen(text) : 1;
  if (length % 2 != 0 || length > 2 * size) return -1;
  for (size_t i = 0; i < length; i += 2) {
    int high = hex_digit(text[i]), low = hex_digit(text[i + 1]);
    if (high < 0 || low < 0) return -1;
    bytes[i / 2] = (uint8_t)(high << 4 | low);
  }
  return (int)(length / 2);
}
