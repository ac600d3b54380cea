#include <gtest/gtest.h>
#include <storage/EepromLayout.h>
#include <storage/RfId.h>

#include "support/Addresses.h"
#include "support/SimulatedEeprom.h"
#include "support/StoredRecord.h"

using javinolib::Address;
using javinolib::RfId;

namespace {

int places() {
  int whole = 0;
  for (uint8_t place = 0; place < javinolib::RF_ID_PLACES; place++) {
    const uint16_t at = static_cast<uint16_t>(javinolib::RF_ID_AT + place * javinolib::RF_ID_RECORD_LENGTH);
    if (!StoredRecord(at, javinolib::RF_ID_LENGTH).read().empty()) whole++;
  }
  return whole;
}

Address afterReboot() {
  RfId id;
  id.begin();
  return id.address();
}

}  // namespace

TEST(RfId, is_not_set_at_first) {
  SimulatedEeprom eeprom;
  EXPECT_TRUE(afterReboot().isSerial());
}

TEST(RfId, is_kept_over_a_reboot) {
  SimulatedEeprom eeprom;
  RfId id;
  EXPECT_TRUE(id.set(ROMA));
  EXPECT_EQ(ROMA, afterReboot());
}

TEST(RfId, the_same_again_writes_nothing) {
  SimulatedEeprom eeprom;
  RfId id;
  id.set(ROMA);
  const int before = eeprom.writes();
  EXPECT_TRUE(id.set(ROMA));
  EXPECT_EQ(before, eeprom.writes());
}

TEST(RfId, many_changes_leave_the_last_alone) {
  SimulatedEeprom eeprom;
  RfId id;
  id.begin();
  for (uint32_t i = 0; i < 600; i++) {
    ASSERT_TRUE(id.set(Address(i)));
    ASSERT_EQ(Address(i), id.address());
    ASSERT_EQ(Address(i), afterReboot());
  }
}

TEST(RfId, a_worn_cell_is_told_and_leaves_the_old_one) {
  for (uint16_t worn = javinolib::RF_ID_AT; worn < javinolib::EPOCHS_AT; worn++) {
    SimulatedEeprom eeprom;
    RfId id;
    id.set(SUPO);
    id.set(ROMA);
    eeprom.wearOut(worn);
    const bool kept = id.set(SUPO);
    EXPECT_EQ(id.address(), afterReboot()) << worn;
    EXPECT_TRUE(id.address() == ROMA || id.address() == SUPO) << worn;
    EXPECT_TRUE(!kept || id.address() == SUPO) << worn;
  }
}

TEST(RfId, one_that_decays_is_none_and_never_an_older_one) {
  SimulatedEeprom fresh;
  RfId id;
  id.set(SUPO);
  id.set(ROMA);
  for (uint16_t bit = 0; bit < (javinolib::EPOCHS_AT - javinolib::RF_ID_AT) * 8; bit++) {
    const uint16_t at = static_cast<uint16_t>(javinolib::RF_ID_AT + bit / 8);
    const uint8_t before = fresh.read(at);
    fresh.corrupt(at, static_cast<uint8_t>(before ^ 1 << bit % 8));
    const Address found = afterReboot();
    EXPECT_TRUE(found == ROMA || found.isSerial()) << bit;
    fresh.corrupt(at, before);
  }
}

TEST(RfId, a_power_cut_at_any_write_leaves_the_old_or_the_new) {
  for (int cut = 0, cuts = 1; cuts > 0; cut++) {
    cuts = 0;
    for (int garbage = 0; garbage < 256; garbage++) {
      SimulatedEeprom eeprom;
      RfId id;
      id.set(SUPP);
      id.set(ROMA);
      eeprom.cutPowerAfter(cut, static_cast<uint8_t>(garbage));
      try {
        id.set(SUPO);
      } catch (const PowerCut &) {
        cuts++;
      }
      eeprom.restorePower();
      const Address found = afterReboot();
      ASSERT_TRUE(found == ROMA || found == SUPO) << cut << " " << garbage;
      ASSERT_EQ(1, places()) << "an old one must not come back when the new one decays";
      RfId after;
      after.begin();
      ASSERT_TRUE(after.set(SUPP));
      ASSERT_EQ(SUPP, afterReboot()) << cut << " " << garbage;
    }
  }
}
