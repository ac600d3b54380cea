#include <gtest/gtest.h>
#include <storage/KeyStore.h>

#include <functional>

#include "support/Addresses.h"
#include "support/Keys.h"
#include "support/SimulatedEeprom.h"

using javinolib::KeyStore;

namespace {

const Bytes FOURTH_KEY = fromHex("8899aabbccddeeff0011223344556677");

// The keys of SUPO, an empty one for none.
struct Keys {
  Bytes current;
  Bytes next;
  Bytes previous;
};

bool is(const KeyStore &store, uint8_t slot, const Bytes &key) {
  return key.empty() ? slot == KeyStore::NO_SLOT : holds(store, slot, key);
}

bool is(const KeyStore &store, const Keys &keys) {
  return is(store, store.current(SUPO), keys.current) && is(store, store.next(SUPO), keys.next) &&
         is(store, store.other(SUPO), keys.next.empty() ? keys.previous : keys.next);
}

// @param freesFirst whether the next key goes to the first place, else behind the others
void begin(KeyStore &store, const Keys &keys, bool freesFirst) {
  store.begin();
  store.set(SUPP, freesFirst ? FOURTH_KEY.data() : THIRD_KEY.data());
  if (!keys.previous.empty()) {
    store.set(SUPO, keys.previous.data());
    store.renew(SUPO, keys.current.data());
    store.use(SUPO);
  } else if (!keys.current.empty()) {
    store.set(SUPO, keys.current.data());
  }
  if (!keys.next.empty()) store.renew(SUPO, keys.next.data());
  store.set(SUPP, THIRD_KEY.data());
}

// Cuts the power at each write of a change, with several kinds of garbage, and once more in the boot that mends it.
void expectAllOrNothing(const Keys &before, const std::function<void(KeyStore &)> &change, const Keys &after,
                        bool freesFirst) {
  for (int cut = 0, cuts = 1; cuts > 0; cut++) {
    cuts = 0;
    for (uint8_t garbage : {0x00, 0x5A, 0xFF}) {
      for (int cutOfBoot : {0, 1, 20, 50}) {
        SimulatedEeprom eeprom;
        KeyStore store;
        begin(store, before, freesFirst);
        eeprom.cutPowerAfter(cut, garbage);
        try {
          change(store);
        } catch (const PowerCut &) {
          cuts++;
        }
        KeyStore halfBooted;
        eeprom.cutPowerAfter(cutOfBoot, garbage);
        try {
          halfBooted.begin();
        } catch (const PowerCut &) {
        }
        eeprom.restorePower();
        KeyStore booted;
        booted.begin();
        ASSERT_TRUE(is(booted, before) || is(booted, after)) << cut << " " << int(garbage) << " " << cutOfBoot;
        ASSERT_TRUE(holds(booted, booted.current(SUPP), THIRD_KEY)) << cut;
        change(booted);
        ASSERT_TRUE(is(booted, after)) << "done again: " << cut << " " << int(garbage) << " " << cutOfBoot;
      }
    }
  }
}

void expectAllOrNothing(const Keys &before, const std::function<void(KeyStore &)> &change, const Keys &after) {
  for (bool freesFirst : {false, true}) expectAllOrNothing(before, change, after, freesFirst);
}

}  // namespace

TEST(KeyStorePowerCuts, while_setting_the_first_key_leave_none_or_it) {
  expectAllOrNothing({{}, {}, {}}, [](KeyStore &store) { store.set(SUPO, KEY.data()); }, {KEY, {}, {}});
}

TEST(KeyStorePowerCuts, while_replacing_a_key_leave_the_old_or_the_new) {
  expectAllOrNothing({KEY, {}, {}}, [](KeyStore &store) { store.set(SUPO, OTHER_KEY.data()); }, {OTHER_KEY, {}, {}});
}

TEST(KeyStorePowerCuts, while_replacing_two_keys_leave_both_or_the_new) {
  const auto change = [](KeyStore &store) { store.set(SUPO, FOURTH_KEY.data()); };
  expectAllOrNothing({OTHER_KEY, {}, KEY}, change, {FOURTH_KEY, {}, {}});
  expectAllOrNothing({OTHER_KEY, KEY, {}}, change, {FOURTH_KEY, {}, {}});
}

TEST(KeyStorePowerCuts, while_renewing_leave_the_old_or_both) {
  expectAllOrNothing({KEY, {}, {}}, [](KeyStore &store) { store.renew(SUPO, OTHER_KEY.data()); }, {KEY, OTHER_KEY, {}});
}

TEST(KeyStorePowerCuts, while_taking_the_next_key_into_use_leave_both_in_either_role) {
  expectAllOrNothing({KEY, OTHER_KEY, {}}, [](KeyStore &store) { store.use(SUPO); }, {OTHER_KEY, {}, KEY});
}

TEST(KeyStorePowerCuts, while_going_back_to_the_other_key_leave_both_or_it) {
  const auto change = [](KeyStore &store) { store.set(SUPO, KEY.data()); };
  expectAllOrNothing({OTHER_KEY, {}, KEY}, change, {KEY, {}, {}});
  expectAllOrNothing({OTHER_KEY, KEY, {}}, change, {KEY, {}, {}});
  expectAllOrNothing({KEY, OTHER_KEY, {}}, change, {KEY, {}, {}});
}

TEST(KeyStorePowerCuts, while_finishing_leave_both_or_the_new) {
  expectAllOrNothing({OTHER_KEY, {}, KEY},
                     [](KeyStore &store) {
                       const uint8_t previous = store.other(SUPO);
                       if (previous != KeyStore::NO_SLOT) store.erase(previous);
                     },
                     {OTHER_KEY, {}, {}});
}
