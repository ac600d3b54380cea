#include <gtest/gtest.h>
#include <storage/EepromLayout.h>
#include <storage/KeyStore.h>

#include "support/Addresses.h"
#include "support/Keys.h"
#include "support/SimulatedEeprom.h"

using javinolib::Address;
using javinolib::DerivedKeys;
using javinolib::KeyStore;
using javinolib::Status;

namespace {

bool holdsSecretsOf(const SimulatedEeprom &eeprom, const Bytes &key) {
  DerivedKeys derived;
  derived.derive(key.data());
  return contains(eeprom.content(), Bytes(derived.encryption, derived.encryption + 16)) ||
         contains(eeprom.content(), Bytes(derived.authentication, derived.authentication + 16));
}

class KeyStoreTest : public testing::Test {
 protected:
  KeyStoreTest() { store.begin(); }

  SimulatedEeprom eeprom;
  KeyStore store;
};

}  // namespace

TEST_F(KeyStoreTest, keeps_a_key_over_a_reboot) {
  EXPECT_EQ(Status::OK, store.set(SUPO, KEY.data()));
  KeyStore after;
  after.begin();
  EXPECT_TRUE(holds(after, after.current(SUPO), KEY));
  EXPECT_EQ(KeyStore::NO_SLOT, after.other(SUPO));
}

TEST_F(KeyStoreTest, the_same_key_again_writes_nothing) {
  store.set(SUPO, KEY.data());
  const int before = eeprom.writes();
  EXPECT_EQ(Status::OK, store.set(SUPO, KEY.data()));
  EXPECT_EQ(before, eeprom.writes());
}

TEST_F(KeyStoreTest, another_key_replaces_the_old_and_wipes_it) {
  store.set(SUPO, KEY.data());
  EXPECT_TRUE(holdsSecretsOf(eeprom, KEY));
  EXPECT_EQ(Status::OK, store.set(SUPO, OTHER_KEY.data()));
  EXPECT_TRUE(holds(store, store.current(SUPO), OTHER_KEY));
  EXPECT_EQ(KeyStore::NO_SLOT, store.other(SUPO));
  EXPECT_FALSE(holdsSecretsOf(eeprom, KEY));
}

TEST_F(KeyStoreTest, holds_as_many_as_Config_says_and_then_is_full) {
  for (uint8_t i = 0; i < javinolib::config::KEYS; i++) EXPECT_EQ(Status::OK, store.set(Address(i), KEY.data()));
  EXPECT_EQ(Status::STORE_FULL, store.set(SUPO, KEY.data()));
  EXPECT_EQ(Status::STORE_FULL, store.renew(Address(4), OTHER_KEY.data())) << "both keys would stay";
  EXPECT_EQ(Status::OK, store.set(Address(3), OTHER_KEY.data())) << "replacing needs the spare place only";
  EXPECT_TRUE(store.erase(store.current(Address(5))));
  EXPECT_EQ(Status::OK, store.renew(Address(4), OTHER_KEY.data()));
  EXPECT_EQ(Status::STORE_FULL, store.set(SUPO, KEY.data())) << "a next key counts too";
  EXPECT_EQ(Status::OK, store.use(Address(4)));
  EXPECT_EQ(Status::STORE_FULL, store.set(SUPO, KEY.data())) << "a previous one as well";
  EXPECT_EQ(Status::OK, store.set(Address(4), THIRD_KEY.data())) << "it replaces both";
  EXPECT_EQ(Status::OK, store.set(SUPO, KEY.data()));
}

TEST_F(KeyStoreTest, an_erased_key_is_gone_for_good) {
  store.set(SUPO, KEY.data());
  EXPECT_TRUE(store.erase(store.current(SUPO)));
  EXPECT_EQ(KeyStore::NO_SLOT, store.current(SUPO));
  KeyStore after;
  after.begin();
  EXPECT_EQ(KeyStore::NO_SLOT, after.current(SUPO));
  EXPECT_FALSE(holdsSecretsOf(eeprom, KEY));
}

TEST_F(KeyStoreTest, the_key_itself_is_never_in_the_eeprom) {
  store.set(SUPO, KEY.data());
  store.renew(SUPO, OTHER_KEY.data());
  EXPECT_FALSE(contains(eeprom.content(), KEY));
  EXPECT_FALSE(contains(eeprom.content(), OTHER_KEY));
}

TEST_F(KeyStoreTest, a_free_place_has_no_key_for_the_serial_line) {
  EXPECT_EQ(KeyStore::NO_SLOT, store.current(Address::serialLine()));
  EXPECT_EQ(KeyStore::NO_SLOT, store.other(Address::serialLine()));
}

TEST_F(KeyStoreTest, a_worn_place_is_passed_over) {
  eeprom.wearOut(javinolib::KEYS_AT + 20);
  EXPECT_EQ(Status::OK, store.set(SUPO, KEY.data()));
  EXPECT_TRUE(holds(store, store.current(SUPO), KEY));
}

TEST_F(KeyStoreTest, an_eeprom_that_keeps_nothing_is_told_and_the_old_key_stays) {
  store.set(SUPO, KEY.data());
  for (uint16_t at = javinolib::KEYS_AT; at < javinolib::FLOORS_AT; at++) eeprom.wearOut(at);
  EXPECT_EQ(Status::STORE_FAILED, store.set(SUPO, OTHER_KEY.data()));
  EXPECT_EQ(Status::STORE_FAILED, store.renew(SUPO, OTHER_KEY.data()));
  EXPECT_TRUE(holds(store, store.current(SUPO), KEY));
  EXPECT_FALSE(store.erase(store.current(SUPO)));
}

TEST_F(KeyStoreTest, a_decayed_key_is_not_used_and_wiped_at_the_next_boot) {
  store.set(SUPO, KEY.data());
  eeprom.corrupt(javinolib::KEYS_AT + 35, static_cast<uint8_t>(eeprom.read(javinolib::KEYS_AT + 35) ^ 1));
  DerivedKeys keys;
  EXPECT_FALSE(store.load(store.current(SUPO), keys));
  KeyStore after;
  after.begin();
  EXPECT_EQ(KeyStore::NO_SLOT, after.current(SUPO));
  EXPECT_FALSE(holdsSecretsOf(eeprom, KEY));
}
