#include <Arduino.h>
#include <gtest/gtest.h>
#include <storage/EepromLayout.h>

#include "support/Keys.h"
#include "support/StoredRecord.h"
#include "support/TestBoard.h"

namespace {

const uint16_t OLDER_END = 3359;
const uint8_t SECRET = 0x5E;
const uint8_t CAPABILITIES_AT = 1 + 4 + 3;
const uint8_t HAS_RADIO_AND_MEMORY = 3;
const uint8_t HAD_OLDER_MEMORY = 4;

bool tellsOlder(TestBoard &board) {
  const uint8_t capabilities = board.hello().body.at(CAPABILITIES_AT);
  EXPECT_EQ(HAS_RADIO_AND_MEMORY, capabilities & HAS_RADIO_AND_MEMORY);
  return (capabilities & HAD_OLDER_MEMORY) != 0;
}

// The older layout: the RF id in one of the first two places of 7 bytes, then all else.
void fillAsOlder(SimulatedEeprom &eeprom, uint16_t placeOfId) {
  eeprom.use();
  for (uint16_t at = 0; at < 4096; at++) eeprom.corrupt(at, at < OLDER_END ? SECRET : 0xFF);
  for (uint16_t at = 0; at < 2 * javinolib::RF_ID_RECORD_LENGTH; at++) eeprom.corrupt(at, 0xFF);
  StoredRecord(placeOfId, javinolib::RF_ID_LENGTH).write(bytesOf("IDS1"));
}

// Whether nothing is left of it, but perhaps in a cell in which power failed.
bool isWiped(SimulatedEeprom &eeprom) {
  const Bytes content = eeprom.content();
  for (uint16_t at = 0; at < javinolib::LAYOUT_AT; at++) {
    if (content[at] != 0xFF && !eeprom.isWeak(at)) return false;
  }
  return true;
}

Bytes lowBytes(SimulatedEeprom &eeprom) {
  const Bytes content = eeprom.content();
  return Bytes(content.begin(), content.begin() + javinolib::RF_ID_AT);
}

}  // namespace

TEST(EepromLayout, an_older_one_is_wiped_once_wherever_its_rf_id_is) {
  for (uint16_t place : {uint16_t(0), uint16_t(javinolib::RF_ID_RECORD_LENGTH)}) {
    SimulatedEeprom eeprom;
    fillAsOlder(eeprom, place);
    EXPECT_TRUE(javinolib::beginLayout());
    EXPECT_TRUE(isWiped(eeprom));
    const int writes = eeprom.writes();
    EXPECT_TRUE(javinolib::beginLayout());
    EXPECT_EQ(writes, eeprom.writes());
  }
}

TEST(EepromLayout, the_host_is_told_at_each_boot_until_an_rf_id_is_set) {
  TestBoard board;
  fillAsOlder(board.eeprom, 0);
  for (int boot = 0; boot < 2; boot++) {
    board.powerUp();
    EXPECT_TRUE(tellsOlder(board)) << "the port's opening may reset the board before it is asked";
  }
  board.request('I', bytesOf("ROMA"));
  EXPECT_FALSE(tellsOlder(board));
  board.powerUp();
  EXPECT_FALSE(tellsOlder(board));
  EXPECT_EQ(javinolib::Status::OK, board.setKey("SUPO", KEY).status);
}

TEST(EepromLayout, a_cut_of_power_within_the_wiping_leaves_nothing_unwiped_or_untold) {
  for (int cut = 0;; cut = cut < 40 || cut > OLDER_END - 20 ? cut + 1 : cut + 97) {
    SimulatedEeprom eeprom;
    fillAsOlder(eeprom, 0);
    bool done = false;
    eeprom.cutPowerWeaklyAfter(cut, static_cast<uint32_t>(cut));
    try {
      javinolib::beginLayout();
      done = true;
    } catch (const PowerCut &) {
    }
    eeprom.restorePower();
    ASSERT_TRUE(javinolib::beginLayout()) << cut;
    ASSERT_TRUE(isWiped(eeprom)) << cut;
    if (done) break;
  }
}

TEST(EepromLayout, the_low_bytes_are_the_sketchs_and_survive) {
  TestBoard board;
  board.eeprom.use();
  for (uint16_t at = 0; at < 4096; at++) board.eeprom.corrupt(at, 0xFF);
  for (uint16_t at = 0; at < javinolib::RF_ID_AT; at++) board.eeprom.corrupt(at, static_cast<uint8_t>(at));
  const Bytes sketchs = lowBytes(board.eeprom);
  board.powerUp();
  EXPECT_FALSE(tellsOlder(board));
  board.request('I', bytesOf("ROMA"));
  board.setKey("SUPO", KEY);
  board.request('R', {1});
  for (uint8_t counter = 1; counter < 200; counter++) {
    board.receive(sealed(KEY, "ROMA", "SUPO", {0, 0, 5, 0, 0, counter}, "tell;x"));
    for (const PolledMessage &message : board.messages()) board.pollTaking(message.number);
  }
  for (int boot = 0; boot < 40; boot++) board.powerUp();
  EXPECT_EQ(sketchs, lowBytes(board.eeprom));
  EXPECT_EQ("ROMA", textOf(board.hello().body).substr(1, 4));
}
