// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef JAVINO_UTF8_H
#define JAVINO_UTF8_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

// Whether the bytes are well-formed UTF-8 (RFC 3629: no overlong forms, no surrogates).
bool utf8_valid(const uint8_t *bytes, size_t length);

#endif
