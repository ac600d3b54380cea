#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "support/SimulatedEeprom.h"
#include "support/StoredRecord.h"

using javinolib::EepromRecord;

namespace {

const uint8_t DATA_LENGTH = 6;
const uint8_t FIRST_CELL = 3;
const int READINGS = 20;

StoredRecord record() { return StoredRecord(FIRST_CELL, DATA_LENGTH); }

// The bytes that a boot finds; all later readings must be like it.
Bytes bootRecord() {
  const Bytes found = record().begin();
  for (int i = 0; i < READINGS; i++) EXPECT_EQ(found, record().read());
  return found;
}

// Has power fail in each write of a change in turn, and once more while what is left is read; then says whether all
// readings that come later are alike. Many seeds, since a weak cell reads as it likes.
void expectFirm(const Bytes &before, const std::function<void()> &change, const std::vector<Bytes> &allowed) {
  for (int cut = 0, cuts = 1; cuts > 0; cut++) {
    cuts = 0;
    for (uint32_t seed = 1; seed < 400; seed++) {
      SimulatedEeprom eeprom;
      record().write(Bytes(DATA_LENGTH, 0x33));
      record().erase(0);
      if (!before.empty()) record().write(before);
      eeprom.cutPowerWeaklyAfter(cut, seed);
      try {
        change();
      } catch (const PowerCut &) {
        cuts++;
      }
      eeprom.cutPowerWeaklyAfter(static_cast<int>(seed % 4), seed);
      try {
        bootRecord();
      } catch (const PowerCut &) {
      }
      eeprom.restorePower();
      const Bytes first = bootRecord();
      ASSERT_NE(allowed.end(), std::find(allowed.begin(), allowed.end(), first))
          << cut << " " << seed << ": " << toHex(first);
      for (int i = 0; i < READINGS; i++) {
        eeprom.cutPowerWeaklyAfter(0, seed + static_cast<uint32_t>(i));
        try {
          ASSERT_EQ(first, bootRecord()) << "cut " << cut << " seed " << seed << " boot " << i;
        } catch (const PowerCut &) {
        }
        eeprom.restorePower();
      }
      ASSERT_EQ(first, bootRecord()) << cut << " " << seed;
    }
  }
}

}  // namespace

TEST(WeakRecord, that_was_being_written_is_there_or_not_once_and_for_all) {
  const Bytes next = fromHex("010203040506");
  expectFirm({}, [&] { record().write(next); }, {{}, next});
}

TEST(WeakRecord, that_was_being_replaced_is_the_old_the_new_or_none_once_and_for_all) {
  const Bytes old = fromHex("0102030405ff");
  const Bytes next = fromHex("ff0203aa0506");
  expectFirm(old, [&] { record().write(next); }, {{}, old, next});
}

TEST(WeakRecord, that_was_being_erased_is_there_or_not_once_and_for_all) {
  const Bytes old = fromHex("010203040506");
  expectFirm(old, [] { record().erase(3); }, {{}, old});
}

TEST(WeakRecord, is_mended_where_one_byte_of_its_seal_is_weak) {
  for (uint16_t at = FIRST_CELL + DATA_LENGTH; at < FIRST_CELL + DATA_LENGTH + EepromRecord::CHECK_LENGTH; at++) {
    SimulatedEeprom eeprom;
    const Bytes data = fromHex("010203040506");
    record().write(data);
    eeprom.weaken(at, 0xFF);
    for (int i = 0; i < READINGS; i++) EXPECT_EQ(data, bootRecord()) << at;
  }
}

TEST(WeakRecord, that_is_written_over_weak_cells_is_firm) {
  const Bytes data = fromHex("010203040506");
  for (uint16_t at = FIRST_CELL; at < FIRST_CELL + DATA_LENGTH + EepromRecord::CHECK_LENGTH; at++) {
    SimulatedEeprom eeprom;
    record().write(data);
    record().erase(0);
    eeprom.weaken(at, 0x5A);
    ASSERT_TRUE(record().write(data));
    EXPECT_FALSE(eeprom.isWeak(at)) << "byte " << at - FIRST_CELL;
  }
}
