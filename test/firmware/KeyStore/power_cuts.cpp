#include <gtest/gtest.h>
#include <storage/KeyStore.h>

#include <functional>

#include "support/Addresses.h"
#include "support/Keys.h"
#include "support/SimulatedEeprom.h"

using javino::KeyStore;

namespace {

struct Keys {
  Bytes current;
  Bytes previous;
};

bool is(const KeyStore &store, const Keys &keys) {
  const bool current = keys.current.empty() ? store.current(SUPO) == KeyStore::NO_SLOT
                                            : holds(store, store.current(SUPO), keys.current);
  const bool previous = keys.previous.empty() ? store.previous(SUPO) == KeyStore::NO_SLOT
                                              : holds(store, store.previous(SUPO), keys.previous);
  return current && previous;
}

void begin(KeyStore &store, const Keys &keys) {
  store.begin();
  store.set(SUPP, THIRD_KEY.data());
  if (!keys.previous.empty()) store.set(SUPO, keys.previous.data());
  if (!keys.current.empty()) store.renew(SUPO, keys.current.data());
}

// Cuts the power at each write of a change, with several kinds of garbage, and once more in the boot that mends it.
void expectAllOrNothing(const Keys &before, const std::function<void(KeyStore &)> &change, const Keys &after) {
  for (int cut = 0, cuts = 1; cuts > 0; cut++) {
    cuts = 0;
    for (uint8_t garbage : {0x00, 0x5A, 0xFF}) {
      for (int cutOfBoot : {0, 1, 20, 50}) {
        SimulatedEeprom eeprom;
        KeyStore store;
        begin(store, before);
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

}  // namespace

TEST(KeyStorePowerCuts, while_setting_the_first_key_leave_none_or_it) {
  expectAllOrNothing({{}, {}}, [](KeyStore &store) { store.set(SUPO, KEY.data()); }, {KEY, {}});
}

TEST(KeyStorePowerCuts, while_replacing_a_key_leave_the_old_or_the_new) {
  expectAllOrNothing({KEY, {}}, [](KeyStore &store) { store.set(SUPO, OTHER_KEY.data()); }, {OTHER_KEY, {}});
}

TEST(KeyStorePowerCuts, while_replacing_two_keys_leave_both_or_the_new) {
  expectAllOrNothing({OTHER_KEY, KEY}, [](KeyStore &store) { store.set(SUPO, THIRD_KEY.data()); }, {THIRD_KEY, {}});
}

TEST(KeyStorePowerCuts, while_renewing_leave_the_old_or_both) {
  expectAllOrNothing({KEY, {}}, [](KeyStore &store) { store.renew(SUPO, OTHER_KEY.data()); }, {OTHER_KEY, KEY});
}

TEST(KeyStorePowerCuts, while_renewing_again_leave_the_old_pair_or_the_new) {
  expectAllOrNothing({OTHER_KEY, KEY}, [](KeyStore &store) { store.renew(SUPO, THIRD_KEY.data()); }, {THIRD_KEY, OTHER_KEY});
}

TEST(KeyStorePowerCuts, while_going_back_to_the_previous_key_leave_both_or_it) {
  expectAllOrNothing({OTHER_KEY, KEY}, [](KeyStore &store) { store.set(SUPO, KEY.data()); }, {KEY, {}});
}

TEST(KeyStorePowerCuts, while_finishing_leave_both_or_the_new) {
  expectAllOrNothing({OTHER_KEY, KEY}, [](KeyStore &store) {
    const uint8_t previous = store.previous(SUPO);
    if (previous != KeyStore::NO_SLOT) store.erase(previous);
  }, {OTHER_KEY, {}});
}
