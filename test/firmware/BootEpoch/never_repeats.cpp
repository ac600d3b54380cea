#include <gtest/gtest.h>
#include <storage/BootEpoch.h>
#include <storage/EepromLayout.h>

#include "support/SimulatedEeprom.h"

using javinolib::BootEpoch;

namespace {

const uint16_t PLACE = javinolib::EPOCH_RECORD_LENGTH;
const int STORE_WRITES = 18;  // the most that storing takes, twice: seal (3 bytes, erased and written) and three bytes

// Boots once; returns the epoch that may be used from now on, or 0 where the power was cut before.
uint32_t boot(SimulatedEeprom &eeprom) {
  BootEpoch epoch;
  try {
    epoch.begin(false);
  } catch (const PowerCut &) {
    eeprom.restorePower();
    return 0;
  }
  return epoch.status() == javinolib::Status::OK ? epoch.value() : 0;
}

}  // namespace

TEST(BootEpoch, counts_the_boots_from_one) {
  SimulatedEeprom eeprom;
  for (uint32_t expected = 1; expected <= 1000; expected++) ASSERT_EQ(expected, boot(eeprom));
}

TEST(BootEpoch, power_cuts_at_every_write_with_any_garbage_never_repeat_an_epoch) {
  RandomBytes random(9);
  for (int run = 0; run < 200; run++) {
    SimulatedEeprom eeprom;
    uint32_t last = 0;
    for (int i = 0; i < 100; i++) {
      if (random.number(2) == 0) eeprom.cutPowerAfter(static_cast<int>(random.number(STORE_WRITES)), random.byte());
      const uint32_t epoch = boot(eeprom);
      eeprom.restorePower();
      if (epoch == 0) continue;
      ASSERT_GT(epoch, last);
      last = epoch;
    }
  }
}

TEST(BootEpoch, a_place_that_decays_never_makes_it_repeat) {
  RandomBytes random(10);
  SimulatedEeprom eeprom;
  uint32_t last = 0;
  for (int i = 0; i < 2000; i++) {
    const uint16_t copy = random.number(2) == 0 ? javinolib::EPOCHS_AT : javinolib::OTHER_EPOCHS_AT;
    const uint16_t at = static_cast<uint16_t>(copy + random.number(javinolib::EPOCHS_LENGTH));
    if (random.number(3) == 0) eeprom.corrupt(at, static_cast<uint8_t>(eeprom.read(at) ^ 1 << random.number(8)));
    const uint32_t epoch = boot(eeprom);
    ASSERT_GT(epoch, last);
    last = epoch;
  }
}

TEST(BootEpoch, a_worn_place_is_passed_over) {
  SimulatedEeprom eeprom;
  uint32_t last = boot(eeprom);
  for (uint16_t i = 0; i < PLACE; i++) eeprom.wearOut(static_cast<uint16_t>(javinolib::EPOCHS_AT + 3 * PLACE + i));
  for (int i = 0; i < 100; i++) {
    const uint32_t epoch = boot(eeprom);
    ASSERT_GT(epoch, last);
    last = epoch;
  }
}

TEST(BootEpoch, is_not_stored_where_one_copy_only_was_kept) {
  SimulatedEeprom eeprom;
  boot(eeprom);
  for (uint16_t at = javinolib::EPOCHS_AT; at < javinolib::KEYS_AT; at++) {
    const bool inThirdPlace = at >= javinolib::EPOCHS_AT + PLACE && at < javinolib::EPOCHS_AT + 2 * PLACE;
    if (!inThirdPlace) eeprom.wearOut(at);
  }
  for (uint16_t at = javinolib::OTHER_EPOCHS_AT; at < javinolib::LAYOUT_END; at++) eeprom.wearOut(at);
  EXPECT_EQ(0u, boot(eeprom));
}

TEST(BootEpoch, an_eeprom_that_keeps_nothing_is_told) {
  SimulatedEeprom eeprom;
  for (uint16_t at = 0; at < 4096; at++) eeprom.wearOut(at);
  BootEpoch epoch;
  epoch.begin(false);
  EXPECT_EQ(javinolib::Status::STORE_FAILED, epoch.status());
}

TEST(BootEpoch, wear_is_spread_over_the_ring) {
  SimulatedEeprom eeprom;
  for (int i = 0; i < 1600; i++) boot(eeprom);
  for (uint16_t at = javinolib::EPOCHS_AT; at < javinolib::KEYS_AT; at++) EXPECT_LE(eeprom.writesOf(at), 410) << at;
}

TEST(BootEpoch, raised_at_any_moment_with_and_without_power_never_repeats) {
  RandomBytes random(11);
  for (int run = 0; run < 200; run++) {
    SimulatedEeprom eeprom;
    uint32_t last = 0;
    for (int i = 0; i < 50; i++) {
      BootEpoch epoch;
      if (random.number(2) == 0) eeprom.cutPowerAfter(static_cast<int>(random.number(2 * STORE_WRITES)), random.byte());
      try {
        epoch.begin(false);
        ASSERT_GT(epoch.value(), last);
        last = epoch.value();
        const uint32_t higher = last + 1 + random.number(1000);
        epoch.raise(higher);
        ASSERT_EQ(higher, epoch.value());
        last = higher;
      } catch (const PowerCut &) {
      }
      eeprom.restorePower();
    }
  }
}
