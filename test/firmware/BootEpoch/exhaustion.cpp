#include <gtest/gtest.h>
#include <secure/NonceSource.h>
#include <storage/EepromLayout.h>

#include "support/SimulatedEeprom.h"
#include "support/SimulatedRam.h"

using javino::BootEpoch;

namespace {

void store(uint32_t epoch) {
  const Bytes data = {static_cast<uint8_t>(epoch >> 16), static_cast<uint8_t>(epoch >> 8), static_cast<uint8_t>(epoch)};
  javino::EepromRecord(javino::EPOCHS_AT, 3).write(data.data());
}

}  // namespace

TEST(BootEpoch, the_last_one_is_used_and_none_after_it) {
  SimulatedEeprom eeprom;
  SimulatedRam ram;
  store(0xFFFFFD);
  BootEpoch last;
  last.begin(false);
  javino::retained::beginEpoch(last.value());
  EXPECT_EQ(0xFFFFFEu, last.value());
  EXPECT_EQ(javino::Status::OK, javino::NonceSource(last).status());
  for (int i = 0; i < 3; i++) {
    BootEpoch after;
    after.begin(false);
    javino::retained::beginEpoch(after.value());
    EXPECT_EQ(BootEpoch::NONE_LEFT, after.value());
    EXPECT_EQ(javino::Status::NONCE_EXHAUSTED, javino::NonceSource(after).status());
  }
}

TEST(NonceSource, counts_up_from_zero_behind_the_epoch) {
  SimulatedEeprom eeprom;
  SimulatedRam ram;
  store(0x010202);
  BootEpoch epoch;
  epoch.begin(false);
  javino::retained::beginEpoch(epoch.value());
  javino::NonceSource nonces(epoch);
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
  javino::retained::beginEpoch(epoch.value());
  javino::NonceSource nonces(epoch);
  Bytes nonce(6);
  for (uint32_t i = 0; i <= 0xFFFFFF; i++) nonces.take(nonce.data());
  EXPECT_EQ("000001ffffff", toHex(nonce));
  EXPECT_EQ(javino::Status::NONCE_EXHAUSTED, nonces.status());
}
