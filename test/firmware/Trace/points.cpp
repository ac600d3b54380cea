#include <gtest/gtest.h>

#include <support/Trace.h>

#include "support/Fragments.h"
#include "support/Keys.h"
#include "support/TestBoard.h"

namespace trace = javinolib::trace;

namespace {

const char *const NAMES[] = {
    "",
#define POINT(name, first, second) #name,
#include <support/TracePoints.h>
#undef POINT
};

// A board SUPP whose points are kept as text, without those of each run(), of counters and of turns.
class Points : public testing::Test {
 protected:
  Points() {
    board.start("SUPP");
    board.setKey("SUHO", KEY);
    PointRegister::list = &all;
  }
  ~Points() { PointRegister::list = nullptr; }

  std::vector<std::string> told() {
    std::vector<std::string> names;
    for (const PointRegister::Point &point : all) {
      if (point.number > trace::COUNT && point.number != trace::TURN) names.push_back(NAMES[point.number]);
    }
    all.clear();
    return names;
  }

  const PointRegister::Point &last(trace::Point number) {
    for (size_t i = all.size(); i-- != 0;) {
      if (all[i].number == number) return all[i];
    }
    throw std::runtime_error(std::string("not told: ") + NAMES[number]);
  }

  typedef std::vector<std::string> Names;
  std::vector<PointRegister::Point> all;
  TestBoard board;
};

}  // namespace

TEST_F(Points, of_a_message_tell_each_attempt_and_its_end) {
  board.transmit("SUHO", "SUPP", "tell;x");
  board.passSending(60000);
  EXPECT_EQ(8, last(trace::ATTEMPT_FAILED).first);
  EXPECT_EQ(3, last(trace::AWAIT).first);
  const Names names = told();
  ASSERT_EQ(1u + 8 * 4 + 1, names.size());
  EXPECT_EQ((Names{"TAKE_UP", "CONTEND", "SEND", "AWAIT", "ATTEMPT_FAILED", "CONTEND"}),
            Names(names.begin(), names.begin() + 6));
  EXPECT_EQ("UNDELIVERED", names.back());
}

TEST_F(Points, tell_the_slots_that_are_waited_for) {
  board.transmit("SUHO", "SUPP", "tell;x");
  board.sendNext();
  all.clear();
  while (all.empty() || all.back().number != trace::CONTEND) board.pass(1);
  const uint8_t slots = all.back().first;
  uint32_t waited = 0;
  for (; board.radio.sent.size() == 1; waited++) board.pass(1);
  EXPECT_NEAR(slots * board.radio.slotMillis(), waited, board.radio.slotMillis() + 1);
}

TEST_F(Points, of_a_message_received_tell_its_way_to_the_host_and_the_answer) {
  const Bytes frame = sealed(KEY, "SUPP", "SUHO", NONCE, "tell;x");
  board.receive(frame);
  EXPECT_EQ(NONCE[5], last(trace::QUEUED).first);
  board.poll();
  board.pollTaking(0);
  board.passSending(100);
  EXPECT_EQ((Names{"FLOOR_STORED", "QUEUED", "HANDED", "TAKEN", "OWE_DELIVERED", "ANSWER"}), told());
  board.receive(frame);
  board.passSending(100);
  EXPECT_EQ((Names{"OWE_DELIVERED", "ANSWER"}), told());
}

TEST_F(Points, of_a_broadcast_tell_no_byte_of_it_for_a_nonce) {
  for (const char *content : {"x", "tell;longer_than_a_nonce"}) {
    board.receive(plain("////", "SUHO", content));
    EXPECT_EQ(0, last(trace::QUEUED).first) << content;
    EXPECT_EQ(javinolib::KeyStore::NO_SLOT, last(trace::QUEUED).second);
  }
}

TEST_F(Points, tell_why_a_packet_is_dropped) {
  board.receive(sealed(OTHER_KEY, "SUPP", "SUHO", NONCE, "tell;x"));
  EXPECT_EQ(static_cast<uint8_t>(javinolib::Counter::RADIO_BAD_TAG), last(trace::COUNT).first);
}

TEST_F(Points, tell_what_is_stored) {
  board.setKey("SUAM", OTHER_KEY);
  const uint8_t key = last(trace::KEY_STORED).first;
  board.request('D', bytesOf("SUAM"));
  EXPECT_EQ(key, last(trace::KEY_DELETED).first);
  told();
  board.reboot();
  EXPECT_EQ(3, last(trace::EPOCH_STORED).first);
  EXPECT_EQ(1, last(trace::MEMORY).first);
  board.powerUp();
  EXPECT_EQ(0, last(trace::MEMORY).first);
}
