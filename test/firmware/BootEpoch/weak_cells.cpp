#include <gtest/gtest.h>
#include <storage/BootEpoch.h>

#include "support/SimulatedEeprom.h"

using javinolib::BootEpoch;

TEST(WeakEpochs, never_repeat) {
  for (uint32_t seed = 1; seed <= 100; seed++) {
    RandomBytes random(seed);
    SimulatedEeprom eeprom;
    uint32_t last = 0;
    for (int i = 0; i < 200; i++) {
      if (random.number(2) == 0)
        eeprom.cutPowerWeaklyAfter(static_cast<int>(random.number(24)), random.number(1000000));
      BootEpoch epoch;
      try {
        epoch.begin(false);
        ASSERT_EQ(javinolib::Status::OK, epoch.status());
        ASSERT_GT(epoch.value(), last) << seed << " " << i;
        last = epoch.value();
      } catch (const PowerCut &) {
      }
      eeprom.restorePower();
    }
    EXPECT_GT(last, 100u);
  }
}
