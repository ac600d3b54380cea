// Boards that do not hear each other, and one between them that both send to (SPEC 7.4).
#include <gtest/gtest.h>

#include <cstdlib>

#include "support/Air.h"
#include "support/Fragments.h"
#include "support/Keys.h"
#include "support/TestBoard.h"

using javinolib::Counter;

namespace {

// The board SUPP; SUAA, whom it does not hear, sends to SUHO.
class Hidden : public testing::Test {
 protected:
  Hidden() {
    board.start("SUPP");
    board.setKey("SUHO", KEY);
    board.start();
    board.radio.mends = true;
  }

  // Another device is acknowledged after so many ms.
  void answerOther(uint32_t millis, uint8_t hops = 0, uint8_t type = 6, const Bytes &body = Bytes()) {
    board.pass(millis);
    board.radio.heard = true;
    board.pass(150);
    board.radio.heard = false;
    board.radio.arrive(acknowledgement(KEY, "SUAA", "SUHO", NONCE, type, body), {}, javinolib::Trailer::NONE, hops);
    board.pass(1);
  }

  // How long the next message waits, in ms.
  uint32_t wait() {
    board.transmit("SUHO", "SUPP", "tell;x");
    const size_t sent = board.radio.sent.size();
    uint32_t millis = 0;
    for (; board.radio.sent.size() == sent && millis < 5000; millis++) board.pass(1);
    board.finishSending();
    const Bytes &packet = board.radio.sent.back();
    board.pass(8);
    board.receive(acknowledgement(KEY, "SUPP", "SUHO", Bytes(packet.begin() + 10, packet.begin() + 16), 6));
    board.pass(8);
    return millis;
  }

  TestBoard board;
};

}  // namespace

TEST_F(Hidden, a_new_message_yields_to_a_sender_whose_acknowledgements_only_are_heard) {
  answerOther(500);
  EXPECT_LT(wait(), 200u);
  EXPECT_GE(wait(), 80 * 8 - 50u);
  answerOther(50);
  EXPECT_GE(wait(), 80 * 8 - 50u) << "what that acknowledges was heard";
}

TEST_F(Hidden, none_is_known_by_a_relays_copy_by_fragments_or_while_what_is_acknowledged_is_heard) {
  answerOther(500, 1);
  answerOther(500, 0, 7, {1});
  answerOther(20);
  wait();
  EXPECT_LT(wait(), 200u);
}

TEST(HiddenBoards, take_turns) {
  Air air(1);
  Station one("SUAA");
  Station middle("SUBB");
  Station other("SUCC");
  for (Station *each : {&one, &middle, &other}) air.join(*each);
  one.share(middle, KEY);
  other.share(middle, KEY);
  air.inRange = [](const Station &from, const Station &to) { return std::abs(from.id[2] - to.id[2]) <= 1; };
  for (int i = 0; i < 10; i++) {
    for (Station *each : {&one, &other}) EXPECT_TRUE(each->send(middle.id, "tell;" + each->id + std::to_string(i)));
  }
  EXPECT_TRUE(air.settle(60000));
  EXPECT_EQ(20u, middle.received.size());
  uint32_t resent = 0;
  for (Station *each : {&one, &other}) {
    each->board.use();
    resent += each->board.counter(Counter::RADIO_RESENT);
  }
  EXPECT_LT(resent, 20u);
}
