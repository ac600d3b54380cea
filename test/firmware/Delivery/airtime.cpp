// What the radio sends is counted in whole seconds (SPEC 4.5).
#include <gtest/gtest.h>

#include "support/Keys.h"
#include "support/TestBoard.h"

using javinolib::Counter;
using javinolib::Trailer;

namespace {

// The time on the air of all that was sent, in ms: 6 ms are a byte, which is what a mark takes too.
uint32_t airtimeOf(const FakeRadio &radio) {
  uint32_t millis = 0;
  for (size_t i = 0; i < radio.sent.size(); i++) {
    const uint32_t trailer = radio.trailers[i] == Trailer::NONE ? 0 : radio.trailers[i] == Trailer::MARK ? 6 : 78;
    millis += radio.airtimeMillis(static_cast<uint8_t>(radio.sent[i].size())) + trailer;
  }
  return millis;
}

}  // namespace

TEST(Airtime, is_that_of_all_packets_and_their_trailers_in_whole_seconds) {
  TestBoard board;
  board.start("SUPP");
  board.setKey("SUHO", KEY);
  EXPECT_EQ(0u, board.counter(Counter::RADIO_AIRTIME));
  for (int message = 0; message < 12; message++) {
    board.transmit("SUHO", "SUPP", "tell;x");  // to an absent device: all but the first attempt have a mark
    board.passSending(10000);
    ASSERT_EQ(airtimeOf(board.radio) / 1000, board.counter(Counter::RADIO_AIRTIME)) << message;
  }
  EXPECT_EQ(96u, board.radio.sent.size());
  EXPECT_EQ(0u, board.counter(Counter::AIRTIME_WAIT)) << "without a limit";
  board.reboot();
  board.hello();
  EXPECT_EQ(0u, board.counter(Counter::RADIO_AIRTIME));
}

TEST(Airtime, is_not_that_of_a_packet_that_the_radio_refuses) {
  TestBoard board;
  board.start("SUPP");
  board.radio.refuses = true;
  board.transmit("////", "SUPP", "tell;x");
  board.pass(60000);
  EXPECT_EQ(0u, board.counter(Counter::RADIO_AIRTIME));
}
