#include <gtest/gtest.h>
#include <storage/EepromLayout.h>
#include <storage/RfId.h>

#include "support/SimulatedEeprom.h"

using javino::Address;
using javino::RfId;

namespace {

const Address ROMA(0x44e300);
const Address SUPO(0x4943ce);

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

TEST(RfId, a_worn_cell_is_told_and_leaves_none) {
  SimulatedEeprom eeprom;
  RfId id;
  eeprom.wearOut(javino::RF_ID_AT);
  EXPECT_FALSE(id.set(ROMA));
  EXPECT_FALSE(id.isSet());
}

TEST(RfId, a_power_cut_leaves_the_old_the_new_or_none) {
  for (int cut = 0; cut < 6; cut++) {
    for (int garbage = 0; garbage < 256; garbage++) {
      SimulatedEeprom eeprom;
      RfId id;
      id.set(ROMA);
      eeprom.cutPowerAfter(cut, static_cast<uint8_t>(garbage));
      try {
        id.set(SUPO);
      } catch (const PowerCut &) {
      }
      eeprom.restorePower();
      const Address found = afterReboot();
      ASSERT_TRUE(found.isSerial() || found == ROMA || found == SUPO) << cut << " " << garbage;
    }
  }
}
