#include <gtest/gtest.h>
#include <storage/EepromLayout.h>
#include <storage/KeyStore.h>

#include "support/SimulatedEeprom.h"

using javino::Address;
using javino::DerivedKeys;
using javino::KeyStore;

namespace {

const Address SUPO(0x4943ce);
const Bytes KEY = fromHex("000102030405060708090a0b0c0d0e0f");
const Bytes OTHER_KEY = fromHex("2b7e151628aed2a6abf7158809cf4f3c");

bool holds(const KeyStore &store, const Address &address, const Bytes &key) {
  const uint8_t slot = store.find(address);
  DerivedKeys stored;
  DerivedKeys expected;
  expected.derive(key.data());
  return slot != KeyStore::NO_SLOT && store.load(slot, stored) && stored.equals(expected);
}

class KeyStoreTest : public testing::Test {
 protected:
  KeyStoreTest() { store.begin(); }

  SimulatedEeprom eeprom;
  KeyStore store;
};

}  // namespace

TEST_F(KeyStoreTest, keeps_a_key_over_a_reboot) {
  EXPECT_EQ(KeyStore::STORED, store.set(SUPO, KEY.data()));
  KeyStore after;
  after.begin();
  EXPECT_TRUE(holds(after, SUPO, KEY));
}

TEST_F(KeyStoreTest, the_same_key_again_writes_nothing) {
  store.set(SUPO, KEY.data());
  const int before = eeprom.writes();
  EXPECT_EQ(KeyStore::UNCHANGED, store.set(SUPO, KEY.data()));
  EXPECT_EQ(before, eeprom.writes());
}

TEST_F(KeyStoreTest, a_new_key_takes_the_place_of_the_old) {
  store.set(SUPO, KEY.data());
  EXPECT_EQ(KeyStore::STORED, store.set(SUPO, OTHER_KEY.data()));
  EXPECT_TRUE(holds(store, SUPO, OTHER_KEY));
}

TEST_F(KeyStoreTest, holds_as_many_as_Config_says_and_then_is_full) {
  for (uint8_t i = 0; i < javino::config::KEYS; i++) EXPECT_EQ(KeyStore::STORED, store.set(Address(i), KEY.data()));
  EXPECT_EQ(KeyStore::FULL, store.set(SUPO, KEY.data()));
  EXPECT_EQ(KeyStore::STORED, store.set(Address(3), OTHER_KEY.data())) << "replacing needs no place";
  EXPECT_TRUE(store.erase(store.find(Address(5))));
  EXPECT_EQ(KeyStore::STORED, store.set(SUPO, KEY.data()));
}

TEST_F(KeyStoreTest, an_erased_key_is_gone_for_good) {
  store.set(SUPO, KEY.data());
  EXPECT_TRUE(store.erase(store.find(SUPO)));
  EXPECT_EQ(KeyStore::NO_SLOT, store.find(SUPO));
  KeyStore after;
  after.begin();
  EXPECT_EQ(KeyStore::NO_SLOT, after.find(SUPO));
  DerivedKeys derived;
  derived.derive(KEY.data());
  EXPECT_FALSE(contains(eeprom.content(), Bytes(derived.encryption, derived.encryption + 16)));
  EXPECT_FALSE(contains(eeprom.content(), Bytes(derived.authentication, derived.authentication + 16)));
}

TEST_F(KeyStoreTest, the_key_itself_is_never_in_the_eeprom) {
  store.set(SUPO, KEY.data());
  EXPECT_FALSE(contains(eeprom.content(), KEY));
}

TEST_F(KeyStoreTest, a_free_place_has_no_key_for_the_serial_line) {
  EXPECT_EQ(KeyStore::NO_SLOT, store.find(Address::serialLine()));
}

TEST_F(KeyStoreTest, a_worn_cell_is_told_and_leaves_no_key) {
  eeprom.wearOut(javino::KEYS_AT + 20);
  EXPECT_EQ(KeyStore::FAILED, store.set(SUPO, KEY.data()));
  EXPECT_EQ(KeyStore::NO_SLOT, store.find(SUPO));
}

TEST_F(KeyStoreTest, a_decayed_key_is_not_used) {
  store.set(SUPO, KEY.data());
  eeprom.corrupt(javino::KEYS_AT + 20, static_cast<uint8_t>(eeprom.read(javino::KEYS_AT + 20) ^ 1));
  DerivedKeys keys;
  EXPECT_FALSE(store.load(store.find(SUPO), keys));
}

TEST(KeyStore, a_power_cut_at_any_write_leaves_the_old_key_or_none_or_the_new) {
  for (int cut = 0; cut <= javino::KEY_RECORD_LENGTH + 1; cut++) {
    for (uint8_t garbage : {0x00, 0x5A, 0xFF}) {
      SimulatedEeprom eeprom;
      KeyStore store;
      store.begin();
      store.set(SUPO, KEY.data());
      eeprom.cutPowerAfter(cut, garbage);
      try {
        store.set(SUPO, OTHER_KEY.data());
      } catch (const PowerCut &) {
      }
      eeprom.restorePower();
      KeyStore after;
      after.begin();
      EXPECT_TRUE(after.find(SUPO) == KeyStore::NO_SLOT || holds(after, SUPO, KEY) || holds(after, SUPO, OTHER_KEY))
          << cut << " " << static_cast<int>(garbage);
    }
  }
}
