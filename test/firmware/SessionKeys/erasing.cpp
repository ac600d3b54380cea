#include <gtest/gtest.h>
#include <storage/SessionKeys.h>

#include "support/Keys.h"

TEST(SessionKeysErasing, overwrites_the_key_and_knows_its_check_value) {
  javinolib::SessionKeys keys;
  keys.begin();
  const uint8_t check[] = {1, 2, 3};
  keys.set(3, KEY.data(), check);
  EXPECT_EQ(KEY, Bytes(keys.keyAt(3), keys.keyAt(3) + 16));
  keys.erase(3);
  EXPECT_EQ(Bytes(16, 0), Bytes(keys.keyAt(3), keys.keyAt(3) + 16));
  const uint8_t other[] = {3, 2, 1};
  keys.set(3, OTHER_KEY.data(), other);
  EXPECT_TRUE(keys.had(check));
  EXPECT_TRUE(keys.had(other));
}
