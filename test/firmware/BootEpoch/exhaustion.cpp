#include <gtest/gtest.h>
#include <secure/NonceSource.h>
#include <storage/EepromLayout.h>

#include "support/SimulatedEeprom.h"
#include "support/SimulatedRam.h"
#include "support/StoredRecord.h"

using javinolib::BootEpoch;

namespace {

void store(uint32_t epoch) {
  const Bytes data = {static_cast<uint8_t>(epoch >> 16), static_cast<uint8_t>(epoch >> 8), static_cast<uint8_t>(epoch)};
  StoredRecord(javinolib::EPOCHS_AT, 3).write(data);
}

}  // namespace

TEST(BootEpoch, the_last_one_is_used_and_none_after_it) {
  SimulatedEeprom eeprom;
  SimulatedRam ram;
  store(0xFFFFFD);
  BootEpoch last;
  last.begin(false);
  javinolib::retained::beginEpoch(last.value());
  EXPECT_EQ(0xFFFFFEu, last.value());
  EXPECT_EQ(javinolib::Status::OK, javinolib::NonceSource(last).status());
  for (int i = 0; i < 3; i++) {
    BootEpoch after;
    after.begin(false);
    javinolib::retained::beginEpoch(after.value());
    EXPECT_EQ(BootEpoch::NONE_LEFT, after.value());
    EXPECT_EQ(javinolib::Status::NONCE_EXHAUSTED, javinolib::NonceSource(after).status());
  }
}

TEST(NonceSource, counts_up_from_zero_behind_the_epoch) {
  SimulatedEeprom eeprom;
  SimulatedRam ram;
  store(0x010202);
  BootEpoch epoch;
  epoch.begin(false);
  javinolib::retained::beginEpoch(epoch.value());
  javinolib::NonceSource nonces(epoch);
  Bytes nonce(6);
  nonces.take(nonce.data());
  EXPECT_EQ("010203000000", toHex(nonce));
  nonces.take(nonce.data());
  EXPECT_EQ("010203000001", toHex(nonce));
}

TEST(NonceSource, is_exhausted_after_the_last_counter) {
  SimulatedEeprom eeprom;
  SimulatedRam ram;
  BootEpoch epoch;
  epoch.begin(false);
  javinolib::retained::beginEpoch(epoch.value());
  javinolib::NonceSource nonces(epoch);
  Bytes nonce(6);
  for (uint32_t i = 0; i <= 0xFFFFFF; i++) nonces.take(nonce.data());
  EXPECT_EQ("000001ffffff", toHex(nonce));
  EXPECT_EQ(javinolib::Status::NONCE_EXHAUSTED, nonces.status());
}
