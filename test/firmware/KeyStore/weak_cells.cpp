#include <gtest/gtest.h>
#include <storage/KeyStore.h>

#include <functional>

#include "support/Addresses.h"
#include "support/Keys.h"
#include "support/SimulatedEeprom.h"

using javinolib::KeyStore;

namespace {

const int BOOTS = 6;

// All keys of a store, by place: address and check value, and whether it seals.
std::string inventory(const KeyStore &store) {
  std::string all;
  for (uint8_t slot = 0; slot < KeyStore::SLOTS; slot++) {
    if (store.isFree(slot)) continue;
    Bytes line(8);
    store.addressAt(slot).write(line.data());
    store.readCheckValue(slot, line.data() + 4);
    line[7] = slot == store.current(store.addressAt(slot)) ? '!' : '.';
    javinolib::DerivedKeys keys;
    all += toHex(line) + (store.load(slot, keys) ? " " : "? ");
  }
  return all;
}

std::string bootKeys() {
  KeyStore store;
  store.begin();
  return inventory(store);
}

// Power fails in each write of a change, then in one of the boot after it: what the first whole boot finds is what was
// there before the change or after it, and stays so, whenever power fails in later boots.
void expectFirm(const std::function<void(KeyStore &)> &prepare, const std::function<void(KeyStore &)> &change) {
  for (int cut = 0, cuts = 1; cuts > 0; cut++) {
    cuts = 0;
    for (uint32_t seed = 1; seed < 16; seed++) {
      SimulatedEeprom eeprom;
      KeyStore store;
      store.begin();
      store.set(SUPP, THIRD_KEY.data());
      prepare(store);
      const std::string before = bootKeys();
      eeprom.cutPowerWeaklyAfter(cut, seed);
      try {
        change(store);
      } catch (const PowerCut &) {
        cuts++;
      }
      eeprom.cutPowerWeaklyAfter(static_cast<int>(seed % 8), seed);
      try {
        bootKeys();
      } catch (const PowerCut &) {
      }
      eeprom.restorePower();
      const std::string found = bootKeys();
      const bool isOld = found == before;
      for (int i = 0; i < BOOTS; i++) {
        eeprom.cutPowerWeaklyAfter(i % 3, seed + static_cast<uint32_t>(i));
        try {
          bootKeys();
        } catch (const PowerCut &) {
        }
        eeprom.restorePower();
        ASSERT_EQ(found, bootKeys()) << "cut " << cut << " seed " << seed << " boot " << i;
      }
      KeyStore again;
      again.begin();
      change(again);
      const std::string after = bootKeys();
      ASSERT_TRUE(isOld || found == after)
          << "cut " << cut << " seed " << seed << "\nold " << before << "\ngot " << found << "\nnew " << after;
      for (int i = 0; i < BOOTS; i++) ASSERT_EQ(after, bootKeys()) << "cut " << cut << " seed " << seed;
    }
  }
}

}  // namespace

TEST(WeakKeys, the_first_one_is_there_or_not_once_and_for_all) {
  expectFirm([](KeyStore &) {}, [](KeyStore &store) { store.set(SUPO, KEY.data()); });
}

TEST(WeakKeys, one_that_is_replaced_is_the_old_or_the_new_once_and_for_all) {
  expectFirm([](KeyStore &store) { store.set(SUPO, KEY.data()); },
             [](KeyStore &store) { store.set(SUPO, OTHER_KEY.data()); });
}

TEST(WeakKeys, one_that_is_renewed_is_the_old_or_both_once_and_for_all) {
  expectFirm([](KeyStore &store) { store.set(SUPO, KEY.data()); },
             [](KeyStore &store) { store.renew(SUPO, OTHER_KEY.data()); });
}

TEST(WeakKeys, one_that_is_taken_into_use_seals_or_does_not_once_and_for_all) {
  expectFirm(
      [](KeyStore &store) {
        store.set(SUPO, KEY.data());
        store.renew(SUPO, OTHER_KEY.data());
      },
      [](KeyStore &store) { store.use(SUPO); });
}

TEST(WeakKeys, a_renewal_that_ends_leaves_both_or_the_new_once_and_for_all) {
  expectFirm(
      [](KeyStore &store) {
        store.set(SUPO, KEY.data());
        store.renew(SUPO, OTHER_KEY.data());
        store.use(SUPO);
      },
      [](KeyStore &store) {
        const uint8_t previous = store.other(SUPO);
        if (previous != KeyStore::NO_SLOT) store.erase(previous);
      });
}

// A cell that has become unsure without any loss of power, of a record or beside it.
TEST(WeakKeys, one_cell_that_reads_wrong_once_in_a_boot_loses_no_key) {
  SimulatedEeprom written;
  KeyStore store;
  store.begin();
  store.set(SUPP, THIRD_KEY.data());
  store.set(SUPO, KEY.data());
  store.renew(SUPO, OTHER_KEY.data());
  const std::string before = inventory(store);
  for (uint16_t at = 0; at < 300; at++) {
    written.misreadOnce(at);
    bootKeys();
    ASSERT_EQ(before, bootKeys()) << at;
  }
}
