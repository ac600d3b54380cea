#include <crypto/DerivedKeys.h>
#include <gtest/gtest.h>

#include "support/Vectors.h"

TEST(DerivedKeys, derives_all_vectors) {
  for (const Vector &vector : vectors("keys.json", "derivations")) {
    SCOPED_TRACE(vector.toString());
    javinolib::DerivedKeys keys;
    keys.derive(vector.bytes("key").data());
    EXPECT_EQ(vector.text("kenc"), toHex(Bytes(keys.encryption, keys.encryption + sizeof keys.encryption)));
    EXPECT_EQ(vector.text("kmac"), toHex(Bytes(keys.authentication, keys.authentication + sizeof keys.authentication)));
    EXPECT_EQ(vector.text("check"), toHex(Bytes(keys.check, keys.check + sizeof keys.check)));
  }
}

TEST(DerivedKeys, are_equal_for_equal_keys_only) {
  javinolib::DerivedKeys some;
  javinolib::DerivedKeys same;
  javinolib::DerivedKeys other;
  some.derive(Bytes(16, 1).data());
  same.derive(Bytes(16, 1).data());
  other.derive(Bytes(16, 2).data());
  EXPECT_TRUE(some.equals(same));
  EXPECT_FALSE(some.equals(other));
}
