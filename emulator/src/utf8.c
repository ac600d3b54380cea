// SPDX-License-Identifier: GPL-3.0-or-later
#include "utf8.h"

#include <jansson.h>

bool utf8_valid(const uint8_t *bytes, size_t length) {
  json_t *text = json_stringn((const char *)bytes, length);
  json_decref(text);
  return text;
}
