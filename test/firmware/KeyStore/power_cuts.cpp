#include <gtest/gtest.h>
#include <storage/KeyStore.h>

#include <functional>

#include "support/Keys.h"
#include "support/SimulatedEeprom.h"

using javino::Address;
using javino::KeyStore;

namespace {

const Address SUPO(0x4943ce);
const Address SUPP(0x4943cf);
const Bytes FIRST = fromHex("000102030405060708090a0b0c0d0e0f");
const Bytes SECOND = fromHex("2b7e151628aed2a6abf7158809cf4f3c");
const Bytes THIRD = fromHex("ffeeddccbbaa99887766554433221100");

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
  store.set(SUPP, THIRD.data());
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
        ASSERT_TRUE(holds(booted, booted.current(SUPP), THIRD)) << cut;
        change(booted);
        ASSERT_TRUE(is(booted, after)) << "done again: " << cut << " " << int(garbage) << " " << cutOfBoot;
      }
    }
  }
}

}  // namespace

TEST(KeyStorePowerCuts, while_setting_the_first_key_leave_none_or_it) {
  expectAllOrNothing({{}, {}}, [](KeyStore &store) { store.set(SUPO, FIRST.data()); }, {FIRST, {}});
}

TEST(KeyStorePowerCuts, while_replacing_a_key_leave_the_old_or_the_new) {
  expectAllOrNothing({FIRST, {}}, [](KeyStore &store) { store.set(SUPO, SECOND.data()); }, {SECOND, {}});
}

TEST(KeyStorePowerCuts, while_replacing_two_keys_leave_both_or_the_new) {
  expectAllOrNothing({SECOND, FIRST}, [](KeyStore &store) { store.set(SUPO, THIRD.data()); }, {THIRD, {}});
}

TEST(KeyStorePowerCuts, while_renewing_leave_the_old_or_both) {
  expectAllOrNothing({FIRST, {}}, [](KeyStore &store) { store.renew(SUPO, SECOND.data()); }, {SECOND, FIRST});
}

TEST(KeyStorePowerCuts, while_renewing_again_leave_the_old_pair_or_the_new) {
  expectAllOrNothing({SECOND, FIRST}, [](KeyStore &store) { store.renew(SUPO, THIRD.data()); }, {THIRD, SECOND});
}

TEST(KeyStorePowerCuts, while_going_back_to_the_previous_key_leave_both_or_it) {
  expectAllOrNothing({SECOND, FIRST}, [](KeyStore &store) { store.set(SUPO, FIRST.data()); }, {FIRST, {}});
}

TEST(KeyStorePowerCuts, while_finishing_leave_both_or_the_new) {
  expectAllOrNothing({SECOND, FIRST}, [](KeyStore &store) {
    const uint8_t previous = store.previous(SUPO);
    if (previous != KeyStore::NO_SLOT) store.erase(previous);
  }, {SECOND, {}});
}
