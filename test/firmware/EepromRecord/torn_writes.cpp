#include <gtest/gtest.h>

#include "support/SimulatedEeprom.h"
#include "support/StoredRecord.h"

using javinolib::EepromRecord;

namespace {

const uint8_t LENGTH = 10;
const uint8_t AT = 3;

Bytes stored() { return StoredRecord(AT, LENGTH).read(); }

}  // namespace

TEST(EepromRecord, gives_back_what_was_written) {
  RandomBytes random(7);
  SimulatedEeprom eeprom;
  for (int i = 0; i < 500; i++) {
    const Bytes data = random.bytes(LENGTH);
    EXPECT_TRUE(StoredRecord(AT, LENGTH).write(data));
    EXPECT_EQ(data, stored());
  }
}

TEST(EepromRecord, is_not_there_before_the_first_write_and_after_erasing) {
  SimulatedEeprom eeprom;
  const StoredRecord record(AT, LENGTH);
  EXPECT_EQ(Bytes(), stored());
  record.write(Bytes(LENGTH, 1));
  EXPECT_TRUE(record.erase(0));
  EXPECT_EQ(Bytes(), stored());
}

TEST(EepromRecord, the_same_again_writes_nothing) {
  SimulatedEeprom eeprom;
  const StoredRecord record(AT, LENGTH);
  record.write(Bytes(LENGTH, 1));
  const int before = eeprom.writes();
  EXPECT_TRUE(record.write(Bytes(LENGTH, 1)));
  EXPECT_EQ(before, eeprom.writes());
}

TEST(EepromRecord, a_power_cut_leaves_the_old_the_new_or_none) {
  RandomBytes random(8);
  for (int cut = 0; cut < LENGTH + 2 * EepromRecord::CHECK_LENGTH; cut++) {
    for (int garbage = 0; garbage < 256; garbage++) {
      SimulatedEeprom eeprom;
      const Bytes old = random.bytes(LENGTH);
      const Bytes next = random.bytes(LENGTH);
      const StoredRecord record(AT, LENGTH);
      record.write(old);
      eeprom.cutPowerAfter(cut, static_cast<uint8_t>(garbage));
      try {
        record.write(next);
      } catch (const PowerCut &) {
      }
      eeprom.restorePower();
      const Bytes found = stored();
      ASSERT_TRUE(found.empty() || found == old || found == next) << cut << " " << garbage << " " << toHex(found);
    }
  }
}

TEST(EepromRecord, a_worn_cell_is_told) {
  for (uint16_t worn = AT; worn < AT + LENGTH + EepromRecord::CHECK_LENGTH; worn++) {
    SimulatedEeprom eeprom;
    const StoredRecord record(AT, LENGTH);
    record.write(Bytes(LENGTH, 0x55));
    eeprom.corrupt(worn, 0x12);
    eeprom.wearOut(worn);
    EXPECT_FALSE(record.write(Bytes(LENGTH, 0xAA))) << worn;
  }
}

TEST(EepromRecord, any_changed_bit_of_the_data_makes_it_unreadable) {
  SimulatedEeprom eeprom;
  StoredRecord(AT, LENGTH).write(bytesOf("0123456789"));
  for (uint16_t bit = 0; bit < LENGTH * 8; bit++) {
    const uint16_t at = static_cast<uint16_t>(AT + bit / 8);
    const uint8_t before = eeprom.read(at);
    eeprom.corrupt(at, static_cast<uint8_t>(before ^ 1 << bit % 8));
    EXPECT_EQ(Bytes(), stored()) << bit;
    eeprom.corrupt(at, before);
  }
}

TEST(EepromRecord, two_right_bytes_of_the_seal_are_enough_and_one_is_not) {
  const Bytes data = bytesOf("0123456789");
  for (uint8_t wrong = 0; wrong < 8; wrong++) {
    SimulatedEeprom eeprom;
    StoredRecord(AT, LENGTH).write(data);
    for (uint16_t i = 0; i < EepromRecord::CHECK_LENGTH; i++) {
      const uint16_t at = static_cast<uint16_t>(AT + LENGTH + i);
      if ((wrong >> i & 1) != 0) eeprom.corrupt(at, static_cast<uint8_t>(eeprom.read(at) ^ 0x10));
    }
    const bool isThere = wrong == 0 || wrong == 1 || wrong == 2 || wrong == 4;
    EXPECT_EQ(isThere ? data : Bytes(), stored()) << int(wrong);
  }
}

TEST(EepromRecord, erasing_overwrites_the_secrets) {
  SimulatedEeprom eeprom;
  const StoredRecord record(AT, LENGTH);
  record.write(bytesOf("0000secret"));
  EXPECT_TRUE(record.erase(6));
  EXPECT_FALSE(contains(eeprom.content(), bytesOf("secret")));
}
