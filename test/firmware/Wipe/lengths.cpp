#include <gtest/gtest.h>
#include <support/Wipe.h>

#include "support/Bytes.h"

TEST(Wipe, overwrites_what_it_is_given_and_no_more) {
  for (size_t length = 0; length <= 300; length++) {
    Bytes bytes(length + 16, 0xAA);
    javinolib::wipe(bytes.data() + 8, length);
    ASSERT_EQ(Bytes(8, 0xAA) + Bytes(length, 0) + Bytes(8, 0xAA), bytes) << length;
  }
}
