#include <crypto/Cmac.h>
#include <gtest/gtest.h>

#include "support/Wycheproof.h"

TEST(Wycheproof, cmac) {
  EXPECT_EQ("", wronglyJudgedCmacs("firmware's `Cmac`", [](const Bytes &key, const Bytes &message) {
              const javinolib::Aes128 cipher(key.data());
              Bytes tag(16);
              javinolib::cmac(cipher, message.data(), static_cast<uint16_t>(message.size()), tag.data());
              return tag;
            }));
}
