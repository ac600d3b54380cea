#include <gtest/gtest.h>
#include <storage/EepromLayout.h>

#include "support/Keys.h"
#include "support/TestBoard.h"

namespace {

const uint16_t SIZE = javinolib::LAYOUT_END;

Bytes lowBytes(SimulatedEeprom &eeprom) {
  const Bytes content = eeprom.content();
  return Bytes(content.begin(), content.begin() + javinolib::RF_ID_AT);
}

// A board whose sketch has written to each byte that is its own.
class SketchsPart : public testing::Test {
 protected:
  SketchsPart() {
    for (uint16_t at = 0; at < javinolib::RF_ID_AT; at++) board.eeprom.corrupt(at, static_cast<uint8_t>(at));
    sketchs = lowBytes(board.eeprom);
    board.start("ROMA");
    board.setKey("SUPO", KEY);
    board.setKey("KAFE", OTHER_KEY);
  }

  size_t keys() { return board.request('L').body.size() / (4 + 1 + 3); }

  TestBoard board;
  Bytes sketchs;
};

}  // namespace

TEST_F(SketchsPart, survives_all_that_the_board_writes) {
  board.request('R', {1});
  for (uint8_t counter = 1; counter < 200; counter++) {
    board.receive(sealed(KEY, "ROMA", "SUPO", {0, 0, 5, 0, 0, counter}, "tell;x"));
    for (const PolledMessage &message : board.messages()) board.pollTaking(message.number);
  }
  for (int boot = 0; boot < 40; boot++) board.powerUp();
  EXPECT_EQ(sketchs, lowBytes(board.eeprom));
  EXPECT_EQ("ROMA", textOf(board.hello().body).substr(1, 4));
}

TEST_F(SketchsPart, survives_any_byte_anywhere_in_ours_and_so_do_all_keys_but_one) {
  const Bytes whole = board.eeprom.content();
  for (uint16_t at = javinolib::RF_ID_AT; at != SIZE; at = static_cast<uint16_t>(at + (at < SIZE - 64 ? 7 : 1))) {
    for (uint8_t value : {2, 3, 4}) {
      for (uint16_t i = 0; i < SIZE; i++) board.eeprom.corrupt(i, whole[i]);
      board.eeprom.corrupt(at, value);
      board.powerUp();
      board.hello();
      ASSERT_EQ(sketchs, lowBytes(board.eeprom)) << at << " was " << int(value);
      ASSERT_GE(keys(), 1u) << at << " was " << int(value);
    }
  }
}
