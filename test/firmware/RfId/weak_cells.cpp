#include <gtest/gtest.h>
#include <storage/RfId.h>

#include "support/Addresses.h"
#include "support/SimulatedEeprom.h"

using javinolib::Address;
using javinolib::RfId;

namespace {

Address bootId() {
  RfId id;
  id.begin();
  return id.address();
}

}  // namespace

TEST(WeakRfId, is_the_old_or_the_new_once_and_for_all) {
  for (int cut = 0, cuts = 1; cuts > 0; cut++) {
    cuts = 0;
    for (uint32_t seed = 1; seed < 300; seed++) {
      SimulatedEeprom eeprom;
      RfId id;
      id.set(SUPP);
      id.set(ROMA);
      eeprom.cutPowerWeaklyAfter(cut, seed);
      try {
        id.set(SUPO);
      } catch (const PowerCut &) {
        cuts++;
      }
      eeprom.cutPowerWeaklyAfter(static_cast<int>(seed % 5), seed);
      try {
        bootId();
      } catch (const PowerCut &) {
      }
      eeprom.restorePower();
      const Address found = bootId();
      ASSERT_TRUE(found == ROMA || found == SUPO) << cut << " " << seed;
      for (int boots = 0; boots < 10; boots++) ASSERT_EQ(found, bootId()) << cut << " " << seed << " " << boots;
    }
  }
}
