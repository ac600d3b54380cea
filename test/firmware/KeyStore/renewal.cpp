#include <gtest/gtest.h>
#include <storage/EepromLayout.h>
#include <storage/KeyStore.h>

#include "support/Addresses.h"
#include "support/Keys.h"
#include "support/SimulatedEeprom.h"

using javinolib::Address;
using javinolib::KeyStore;
using javinolib::Status;

namespace {

class KeyRenewalTest : public testing::Test {
 protected:
  KeyRenewalTest() { reboot(); }

  void reboot() {
    store = KeyStore();
    store.begin();
  }

  // Expects these keys, an empty one for none, now and after a reboot. The other one is the next, or the previous.
  void expect(const Bytes &current, const Bytes &next, const Bytes &previous = {}) {
    for (int boots = 0; boots < 2; boots++) {
      EXPECT_TRUE(is(store.current(SUPO), current));
      EXPECT_TRUE(is(store.next(SUPO), next));
      EXPECT_TRUE(is(store.other(SUPO), next.empty() ? previous : next));
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

TEST_F(KeyRenewalTest, adds_the_next_key_and_goes_on_with_the_old) {
  store.set(SUPO, KEY.data());
  EXPECT_EQ(Status::OK, store.renew(SUPO, OTHER_KEY.data()));
  expect(KEY, OTHER_KEY);
}

TEST_F(KeyRenewalTest, the_next_key_when_used_keeps_the_old_one_as_previous) {
  store.set(SUPO, KEY.data());
  store.renew(SUPO, OTHER_KEY.data());
  EXPECT_EQ(Status::OK, store.use(SUPO));
  expect(OTHER_KEY, {}, KEY);
}

TEST_F(KeyRenewalTest, is_finished_by_erasing_the_previous_key) {
  store.set(SUPO, KEY.data());
  store.renew(SUPO, OTHER_KEY.data());
  store.use(SUPO);
  EXPECT_TRUE(store.erase(store.other(SUPO)));
  expect(OTHER_KEY, {});
}

TEST_F(KeyRenewalTest, of_no_key_is_refused) {
  EXPECT_EQ(Status::NO_KEY, store.renew(SUPO, KEY.data())) << "it would seal at once";
  expect({}, {});
}

TEST_F(KeyRenewalTest, of_no_next_key_there_is_nothing_to_use) {
  EXPECT_EQ(Status::NO_KEY, store.use(SUPO));
  store.set(SUPO, KEY.data());
  EXPECT_EQ(Status::NO_KEY, store.use(SUPO));
  store.renew(SUPO, OTHER_KEY.data());
  store.use(SUPO);
  EXPECT_EQ(Status::NO_KEY, store.use(SUPO));
  expect(OTHER_KEY, {}, KEY);
}

TEST_F(KeyRenewalTest, the_same_step_again_writes_nothing) {
  store.set(SUPO, KEY.data());
  EXPECT_EQ(Status::OK, store.renew(SUPO, KEY.data()));
  store.renew(SUPO, OTHER_KEY.data());
  const int before = eeprom.writes();
  EXPECT_EQ(Status::OK, store.renew(SUPO, OTHER_KEY.data()));
  EXPECT_EQ(before, eeprom.writes());
  store.use(SUPO);
  EXPECT_EQ(Status::OK, store.renew(SUPO, OTHER_KEY.data()));
  EXPECT_EQ(before + 1, eeprom.writes()) << "use writes one byte";
  expect(OTHER_KEY, {}, KEY);
}

TEST_F(KeyRenewalTest, while_another_is_not_finished_is_refused) {
  store.set(SUPO, KEY.data());
  store.renew(SUPO, OTHER_KEY.data());
  const int before = eeprom.writes();
  EXPECT_EQ(Status::BAD_ARGUMENT, store.renew(SUPO, THIRD_KEY.data()));
  EXPECT_EQ(Status::BAD_ARGUMENT, store.renew(SUPO, KEY.data()));
  EXPECT_EQ(before, eeprom.writes());
  store.use(SUPO);
  EXPECT_EQ(Status::BAD_ARGUMENT, store.renew(SUPO, THIRD_KEY.data()));
  EXPECT_EQ(Status::BAD_ARGUMENT, store.renew(SUPO, KEY.data())) << "the previous key must not come back so";
  expect(OTHER_KEY, {}, KEY);
}

TEST_F(KeyRenewalTest, setting_the_current_key_ends_it_at_either_step) {
  store.set(SUPO, KEY.data());
  store.renew(SUPO, OTHER_KEY.data());
  EXPECT_EQ(Status::OK, store.set(SUPO, KEY.data()));
  expect(KEY, {});
  store.renew(SUPO, OTHER_KEY.data());
  store.use(SUPO);
  EXPECT_EQ(Status::OK, store.set(SUPO, OTHER_KEY.data()));
  expect(OTHER_KEY, {});
}

TEST_F(KeyRenewalTest, setting_the_other_key_leaves_it_alone_in_its_place) {
  store.set(SUPO, KEY.data());
  const uint8_t place = store.current(SUPO);
  store.renew(SUPO, OTHER_KEY.data());
  store.use(SUPO);
  EXPECT_EQ(Status::OK, store.set(SUPO, KEY.data()));
  EXPECT_EQ(place, store.current(SUPO)) << "so that its floors go on to count";
  expect(KEY, {});
  store.renew(SUPO, OTHER_KEY.data());
  EXPECT_EQ(Status::OK, store.set(SUPO, OTHER_KEY.data()));
  expect(OTHER_KEY, {});
  store.renew(SUPO, THIRD_KEY.data());
  expect(OTHER_KEY, THIRD_KEY);
  store.use(SUPO);
  expect(THIRD_KEY, {}, OTHER_KEY);
}

TEST_F(KeyRenewalTest, setting_a_third_key_deletes_both) {
  store.set(SUPO, KEY.data());
  store.renew(SUPO, OTHER_KEY.data());
  EXPECT_EQ(Status::OK, store.set(SUPO, THIRD_KEY.data()));
  expect(THIRD_KEY, {});
  store.renew(SUPO, KEY.data());
  store.use(SUPO);
  EXPECT_EQ(Status::OK, store.set(SUPO, OTHER_KEY.data()));
  expect(OTHER_KEY, {});
}

TEST_F(KeyRenewalTest, goes_on_over_more_keys_than_generations) {
  Bytes key = KEY;
  store.set(SUPO, key.data());
  for (int i = 0; i < 600; i++) {
    const Bytes before = key;
    key[i % 16]++;
    ASSERT_EQ(Status::OK, store.renew(SUPO, key.data()));
    expect(before, key);
    ASSERT_EQ(Status::OK, store.use(SUPO));
    expect(key, {}, before);
    ASSERT_TRUE(store.erase(store.other(SUPO)));
  }
}

TEST_F(KeyRenewalTest, whose_use_the_eeprom_does_not_keep_is_told_and_changes_nothing) {
  store.set(SUPO, KEY.data());
  store.renew(SUPO, OTHER_KEY.data());
  for (uint16_t at = 0; at < 4096; at++) eeprom.wearOut(at);
  EXPECT_EQ(Status::STORE_FAILED, store.use(SUPO));
  expect(KEY, OTHER_KEY);
}

TEST_F(KeyRenewalTest, does_not_take_a_place_whose_last_use_it_cannot_erase) {
  store.set(SUPO, KEY.data());
  store.renew(SUPO, OTHER_KEY.data());
  const uint16_t mark = static_cast<uint16_t>(javinolib::KEYS_AT + 2 * javinolib::KEY_PLACE_LENGTH - 1);
  store.use(SUPO);
  ASSERT_EQ(0, eeprom.read(mark));
  store.set(SUPO, KEY.data());
  eeprom.wearOut(mark);
  EXPECT_EQ(Status::OK, store.renew(SUPO, THIRD_KEY.data()));
  expect(KEY, THIRD_KEY);
}

TEST_F(KeyRenewalTest, of_one_address_leaves_the_others_alone) {
  for (uint8_t i = 0; i < 5; i++) store.set(Address(i), KEY.data());
  store.renew(Address(2), OTHER_KEY.data());
  store.use(Address(2));
  store.set(Address(3), OTHER_KEY.data());
  reboot();
  for (uint8_t i : {0, 1, 4}) EXPECT_TRUE(holds(store, store.current(Address(i)), KEY));
  for (uint8_t i : {0, 1, 3, 4}) EXPECT_EQ(KeyStore::NO_SLOT, store.other(Address(i)));
}
