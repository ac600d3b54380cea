#include <gtest/gtest.h>
#include <storage/KeyStore.h>

#include "support/Addresses.h"
#include "support/Keys.h"
#include "support/SimulatedEeprom.h"

using javino::Address;
using javino::KeyStore;

namespace {

class KeyRenewalTest : public testing::Test {
 protected:
  KeyRenewalTest() { reboot(); }

  void reboot() {
    store = KeyStore();
    store.begin();
  }

  // Expects these keys, an empty one for none, now and after a reboot.
  void expect(const Bytes &current, const Bytes &previous) {
    for (int boots = 0; boots < 2; boots++) {
      EXPECT_TRUE(is(store.current(SUPO), current));
      EXPECT_TRUE(is(store.previous(SUPO), previous));
      reboot();
    }
  }

  bool is(uint8_t slot, const Bytes &key) const {
    return key.empty() ? slot == KeyStore::NO_SLOT : holds(store, slot, key);
  }

  SimulatedEeprom eeprom;
  KeyStore store;
};

}  // namespace

TEST_F(KeyRenewalTest, keeps_the_old_key_as_previous) {
  store.set(SUPO, KEY.data());
  EXPECT_EQ(KeyStore::STORED, store.renew(SUPO, OTHER_KEY.data()));
  expect(OTHER_KEY, KEY);
}

TEST_F(KeyRenewalTest, a_second_one_deletes_the_previous_key) {
  store.set(SUPO, KEY.data());
  store.renew(SUPO, OTHER_KEY.data());
  EXPECT_EQ(KeyStore::STORED, store.renew(SUPO, THIRD_KEY.data()));
  expect(THIRD_KEY, OTHER_KEY);
}

TEST_F(KeyRenewalTest, of_no_key_just_stores_it) {
  EXPECT_EQ(KeyStore::STORED, store.renew(SUPO, KEY.data()));
  expect(KEY, {});
}

TEST_F(KeyRenewalTest, to_the_current_key_writes_nothing) {
  store.set(SUPO, KEY.data());
  store.renew(SUPO, OTHER_KEY.data());
  const int before = eeprom.writes();
  EXPECT_EQ(KeyStore::UNCHANGED, store.renew(SUPO, OTHER_KEY.data()));
  EXPECT_EQ(before, eeprom.writes());
  expect(OTHER_KEY, KEY);
}

TEST_F(KeyRenewalTest, to_the_previous_key_is_refused) {
  store.set(SUPO, KEY.data());
  store.renew(SUPO, OTHER_KEY.data());
  const int before = eeprom.writes();
  EXPECT_EQ(KeyStore::IS_PREVIOUS, store.renew(SUPO, KEY.data()));
  EXPECT_EQ(before, eeprom.writes());
  expect(OTHER_KEY, KEY);
}

TEST_F(KeyRenewalTest, is_finished_by_erasing_the_previous_key) {
  store.set(SUPO, KEY.data());
  store.renew(SUPO, OTHER_KEY.data());
  EXPECT_TRUE(store.erase(store.previous(SUPO)));
  expect(OTHER_KEY, {});
}

TEST_F(KeyRenewalTest, setting_the_current_key_finishes_it) {
  store.set(SUPO, KEY.data());
  store.renew(SUPO, OTHER_KEY.data());
  EXPECT_EQ(KeyStore::STORED, store.set(SUPO, OTHER_KEY.data()));
  expect(OTHER_KEY, {});
}

TEST_F(KeyRenewalTest, setting_the_previous_key_takes_it_back_in_its_place) {
  store.set(SUPO, KEY.data());
  const uint8_t place = store.current(SUPO);
  store.renew(SUPO, OTHER_KEY.data());
  EXPECT_EQ(KeyStore::STORED, store.set(SUPO, KEY.data()));
  EXPECT_EQ(place, store.current(SUPO)) << "so that its floors go on to count";
  expect(KEY, {});
}

TEST_F(KeyRenewalTest, setting_another_key_deletes_both) {
  store.set(SUPO, KEY.data());
  store.renew(SUPO, OTHER_KEY.data());
  EXPECT_EQ(KeyStore::STORED, store.set(SUPO, THIRD_KEY.data()));
  expect(THIRD_KEY, {});
}

TEST_F(KeyRenewalTest, goes_on_over_more_keys_than_generations) {
  Bytes key = KEY;
  store.set(SUPO, key.data());
  for (int i = 0; i < 600; i++) {
    const Bytes before = key;
    key[i % 16]++;
    ASSERT_EQ(KeyStore::STORED, store.renew(SUPO, key.data()));
    expect(key, before);
  }
}

TEST_F(KeyRenewalTest, of_one_address_leaves_the_others_alone) {
  for (uint8_t i = 0; i < 5; i++) store.set(Address(i), KEY.data());
  store.renew(Address(2), OTHER_KEY.data());
  store.set(Address(3), OTHER_KEY.data());
  reboot();
  for (uint8_t i : {0, 1, 4}) EXPECT_TRUE(holds(store, store.current(Address(i)), KEY));
  for (uint8_t i : {0, 1, 3, 4}) EXPECT_EQ(KeyStore::NO_SLOT, store.previous(Address(i)));
}
