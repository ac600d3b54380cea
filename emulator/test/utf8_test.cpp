// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <string>

extern "C" {
#include "utf8.h"
}

static bool valid(const std::string &text) {
  return utf8_valid(reinterpret_cast<const uint8_t *>(text.data()), text.size());
}

TEST(Utf8, well_formed_text_is_valid) {
  for (const char *good : {"", "abc", "é", "€", "😀", "\xF4\x8F\xBF\xBF", "\xED\x9F\xBF"})
    EXPECT_TRUE(valid(good)) << good;
}

TEST(Utf8, ill_formed_text_is_not) {
  for (const char *bad : {"\x80", "\xC3", "\xC0\x80", "\xC1\xBF", "\xE0\x9F\xBF", "\xED\xA0\x80", "\xE2\x82",
                          "\xF0\x8F\xBF\xBF", "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xFF", "a\xC3z"})
    EXPECT_FALSE(valid(bad));
}
