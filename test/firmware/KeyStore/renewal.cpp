#include <gtest/gtest.h>
#include <storage/KeyStore.h>

#include "support/Keys.h"
#include "support/SimulatedEeprom.h"

using javino::Address;
using javino::KeyStore;

namespace {

const Address SUPO(0x4943ce);
const Bytes FIRST = fromHex("000102030405060708090a0b0c0d0e0f");
const Bytes SECOND = fromHex("2b7e151628aed2a6abf7158809cf4f3c");
const Bytes THIRD = fromHex("ffeeddccbbaa99887766554433221100");

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
  store.set(SUPO, FIRST.data());
  EXPECT_EQ(KeyStore::STORED, store.renew(SUPO, SECOND.data()));
  expect(SECOND, FIRST);
}

TEST_F(KeyRenewalTest, a_second_one_deletes_the_previous_key) {
  store.set(SUPO, FIRST.data());
  store.renew(SUPO, SECOND.data());
  EXPECT_EQ(KeyStore::STORED, store.renew(SUPO, THIRD.data()));
  expect(THIRD, SECOND);
}

TEST_F(KeyRenewalTest, of_no_key_just_stores_it) {
  EXPECT_EQ(KeyStore::STORED, store.renew(SUPO, FIRST.data()));
  expect(FIRST, {});
}

TEST_F(KeyRenewalTest, to_the_current_key_writes_nothing) {
  store.set(SUPO, FIRST.data());
  store.renew(SUPO, SECOND.data());
  const int before = eeprom.writes();
  EXPECT_EQ(KeyStore::UNCHANGED, store.renew(SUPO, SECOND.data()));
  EXPECT_EQ(before, eeprom.writes());
  expect(SECOND, FIRST);
}

TEST_F(KeyRenewalTest, to_the_previous_key_is_refused) {
  store.set(SUPO, FIRST.data());
  store.renew(SUPO, SECOND.data());
  const int before = eeprom.writes();
  EXPECT_EQ(KeyStore::IS_PREVIOUS, store.renew(SUPO, FIRST.data()));
  EXPECT_EQ(before, eeprom.writes());
  expect(SECOND, FIRST);
}

TEST_F(KeyRenewalTest, is_finished_by_erasing_the_previous_key) {
  store.set(SUPO, FIRST.data());
  store.renew(SUPO, SECOND.data());
  EXPECT_TRUE(store.erase(store.previous(SUPO)));
  expect(SECOND, {});
}

TEST_F(KeyRenewalTest, setting_the_current_key_finishes_it) {
  store.set(SUPO, FIRST.data());
  store.renew(SUPO, SECOND.data());
  EXPECT_EQ(KeyStore::STORED, store.set(SUPO, SECOND.data()));
  expect(SECOND, {});
}

TEST_F(KeyRenewalTest, setting_the_previous_key_takes_it_back_in_its_place) {
  store.set(SUPO, FIRST.data());
  const uint8_t place = store.current(SUPO);
  store.renew(SUPO, SECOND.data());
  EXPECT_EQ(KeyStore::STORED, store.set(SUPO, FIRST.data()));
  EXPECT_EQ(place, store.current(SUPO)) << "so that its floors go on to count";
  expect(FIRST, {});
}

TEST_F(KeyRenewalTest, setting_another_key_deletes_both) {
  store.set(SUPO, FIRST.data());
  store.renew(SUPO, SECOND.data());
  EXPECT_EQ(KeyStore::STORED, store.set(SUPO, THIRD.data()));
  expect(THIRD, {});
}

TEST_F(KeyRenewalTest, goes_on_over_more_keys_than_generations) {
  Bytes key = FIRST;
  store.set(SUPO, key.data());
  for (int i = 0; i < 600; i++) {
    const Bytes before = key;
    key[i % 16]++;
    ASSERT_EQ(KeyStore::STORED, store.renew(SUPO, key.data()));
    expect(key, before);
  }
}

TEST_F(KeyRenewalTest, of_one_address_leaves_the_others_alone) {
  for (uint8_t i = 0; i < 5; i++) store.set(Address(i), FIRST.data());
  store.renew(Address(2), SECOND.data());
  store.set(Address(3), SECOND.data());
  reboot();
  for (uint8_t i : {0, 1, 4}) EXPECT_TRUE(holds(store, store.current(Address(i)), FIRST));
  for (uint8_t i : {0, 1, 3, 4}) EXPECT_EQ(KeyStore::NO_SLOT, store.previous(Address(i)));
}
