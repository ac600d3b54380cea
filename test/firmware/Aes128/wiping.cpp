#include <crypto/Aes128.h>
#include <gtest/gtest.h>

#include <new>

#include "support/Bytes.h"

TEST(Aes128, round_keys_are_wiped_at_the_end_of_life) {
  alignas(javinolib::Aes128) uint8_t place[sizeof(javinolib::Aes128)];
  javinolib::Aes128 *cipher = new (place) javinolib::Aes128(Bytes(16, 0x77).data());
  cipher->~Aes128();
  const volatile uint8_t *left = place;
  for (size_t i = 0; i < sizeof place; i++) ASSERT_EQ(0, left[i]) << i;
}
