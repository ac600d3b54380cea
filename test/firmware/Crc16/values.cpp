#include <support/Crc16.h>
#include <gtest/gtest.h>

#include "support/Reference.h"

static uint16_t crcOf(const Bytes &bytes) {
  javinolib::Crc16 crc;
  crc.add(bytes.data(), bytes.size());
  return crc.value();
}

TEST(Crc16, has_the_check_value_of_SPEC_4_1) { EXPECT_EQ(0x906E, crcOf(bytesOf("123456789"))); }

TEST(Crc16, of_nothing_is_zero) { EXPECT_EQ(0, crcOf({})); }

TEST(Crc16, agrees_with_its_definition_bit_by_bit) {
  RandomBytes random(2);
  for (int i = 0; i < 2000; i++) {
    const Bytes bytes = random.bytes(random.number(100));
    ASSERT_EQ(reference::crc(bytes), crcOf(bytes));
  }
}
