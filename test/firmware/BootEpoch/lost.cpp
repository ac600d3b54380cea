#include <gtest/gtest.h>
#include <secure/NonceSource.h>
#include <storage/EepromLayout.h>

#include <array>

#include "support/SimulatedEeprom.h"
#include "support/SimulatedRam.h"

using javinolib::BootEpoch;

namespace {

// As a sketch does that takes these bytes for its own.
void writeOver(SimulatedEeprom &eeprom, uint16_t at, uint8_t value) {
  for (uint16_t i = 0; i < javinolib::EPOCHS_LENGTH; i++) eeprom.corrupt(static_cast<uint16_t>(at + i), value);
}

uint32_t boot(bool hasKeys) {
  BootEpoch epoch;
  epoch.begin(hasKeys);
  EXPECT_EQ(epoch.value() == 0 ? javinolib::Status::EPOCH_LOST : javinolib::Status::OK, epoch.status());
  return epoch.value();
}

}  // namespace

TEST(LostBootEpoch, begins_at_one_only_where_no_key_is_stored) {
  SimulatedEeprom eeprom;
  EXPECT_EQ(0u, boot(true));
  EXPECT_EQ(0u, boot(true)) << "and does not begin by itself";
  EXPECT_EQ(0, eeprom.writes());
  EXPECT_EQ(1u, boot(false));
  EXPECT_EQ(2u, boot(true));
}

TEST(LostBootEpoch, is_not_lost_while_one_end_of_the_EEPROM_is_left) {
  for (uint16_t end : {javinolib::EPOCHS_AT, javinolib::OTHER_EPOCHS_AT}) {
    for (uint8_t value : {0x00, 0x5A, 0xFF}) {
      SimulatedEeprom eeprom;
      uint32_t last = boot(false);
      for (int i = 0; i < 40; i++) {
        if (i % 3 != 0) writeOver(eeprom, end, value);
        const uint32_t epoch = boot(true);
        ASSERT_EQ(last + 1, epoch);
        last = epoch;
      }
    }
  }
}

TEST(LostBootEpoch, never_comes_again_whatever_parts_of_both_ends_are_written_over) {
  RandomBytes random(12);
  int lost = 0;
  for (int run = 0; run < 500; run++) {
    SimulatedEeprom eeprom;
    uint32_t last = boot(false);
    for (uint32_t boots = random.number(40); boots > 0; boots--) last = boot(true);
    const uint8_t value = std::array<uint8_t, 3>{0x00, 0x5A, 0xFF}[random.number(3)];
    for (uint16_t end : {javinolib::EPOCHS_AT, javinolib::OTHER_EPOCHS_AT}) {
      const uint16_t from = static_cast<uint16_t>(random.number(javinolib::EPOCHS_LENGTH));
      for (uint16_t at = from; at < javinolib::EPOCHS_LENGTH && random.number(20) != 0; at++)
        eeprom.corrupt(static_cast<uint16_t>(end + at), value);
    }
    BootEpoch epoch;
    epoch.begin(true);
    const bool raised = epoch.value() == 0;
    if (raised) {
      lost++;
      epoch.raise(last + 1);
    }
    ASSERT_EQ(last + 1, epoch.value()) << run;
    const uint32_t next = boot(true);
    ASSERT_TRUE(next == last + 2 || (!raised && next == 0)) << run;
  }
  EXPECT_GT(lost, 20);
  EXPECT_LT(lost, 200);
}

TEST(LostBootEpoch, is_not_lost_by_losses_of_power) {
  RandomBytes random(13);
  for (int run = 0; run < 200; run++) {
    SimulatedEeprom eeprom;
    boot(false);
    for (int i = 0; i < 50; i++) {
      BootEpoch epoch;
      eeprom.cutPowerAfter(static_cast<int>(random.number(24)), random.byte());
      try {
        epoch.begin(true);
        ASSERT_NE(0u, epoch.value());
      } catch (const PowerCut &) {
      }
      eeprom.restorePower();
    }
  }
}

TEST(LostBootEpoch, seals_nothing_until_it_is_raised) {
  SimulatedEeprom eeprom;
  SimulatedRam ram;
  BootEpoch epoch;
  epoch.begin(true);
  javinolib::retained::beginEpoch(epoch.value());
  javinolib::NonceSource nonces(epoch);
  EXPECT_EQ(javinolib::Status::EPOCH_LOST, nonces.status());
  nonces.raiseEpoch(0);
  EXPECT_EQ(javinolib::Status::EPOCH_LOST, nonces.status());
  nonces.raiseEpoch(470012);
  EXPECT_EQ(javinolib::Status::OK, nonces.status());
  EXPECT_EQ(470013u, boot(true));
}
