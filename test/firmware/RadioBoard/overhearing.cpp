#include <gtest/gtest.h>

#include <support/Clock.h>

#include "support/Keys.h"
#include "support/TestBoard.h"

using javinolib::Counter;
using javinolib::Status;

namespace {

const Bytes ON = {1};
const Bytes OFF = {0};
const size_t LONGEST_PACKET = 77;
const size_t RECORD = 2 + 4 + 1;  // beside the payload

// A record `O` of a poll reply.
struct Packet {
  explicit Packet(const Bytes &value)
      : time(static_cast<uint32_t>(value.at(0) << 24 | value.at(1) << 16 | value.at(2) << 8 | value.at(3))),
        how(value.at(4)),
        payload(value.begin() + 5, value.end()) {}

  uint32_t time;
  int how;
  Bytes payload;
};

// A board SUHO that overhears.
class BoardOverhearing : public testing::Test {
 protected:
  BoardOverhearing() {
    board.start("SUHO");
    board.setKey("SUPP", KEY);
    EXPECT_EQ(Status::OK, board.request('O', ON).status);
  }

  static std::vector<Packet> packets(const PollReply &reply) {
    std::vector<Packet> all;
    for (const PollRecord &record : reply.records) {
      if (record.type == 'O') all.emplace_back(record.value);
    }
    return all;
  }

  std::vector<Packet> overheard(uint8_t flags = 0) {
    board.hold(flags, 0);
    return packets(board.takeReply());
  }

  static Bytes toOther(char last) { return sealed(OTHER_KEY, "SUPO", "ROMA", {0, 0, 1, 0, 0, 9}, {'x', last}); }

  TestBoard board;
};

}  // namespace

TEST_F(BoardOverhearing, tells_each_packet_whoever_it_is_for_with_the_time_at_which_it_came) {
  const std::vector<Bytes> all = {toOther('a'), plain("////", "ROMA", "tell;help"), plain("+KAA", "ROMA", "12345678"),
                                  bytesOf("no frame")};
  std::vector<uint32_t> times;
  for (const Bytes &payload : all) {
    board.pass(100);
    times.push_back(javinolib::clock::millis());
    board.receive(payload);
  }
  const std::vector<Packet> told = overheard();
  ASSERT_EQ(all.size(), told.size());
  for (size_t i = 0; i < all.size(); i++) {
    EXPECT_EQ(all[i], told[i].payload);
    EXPECT_EQ(0, told[i].how);
    EXPECT_EQ(times[i], told[i].time);
  }
}

TEST_F(BoardOverhearing, tells_what_is_for_the_board_as_it_came_and_delivers_it) {
  const Bytes packet = sealed(KEY, "SUHO", "SUPP", {0, 0, 1, 0, 0, 1}, "tell;x");
  board.receive(packet);
  const PollReply reply = board.poll();
  ASSERT_EQ(2u, reply.records.size());
  EXPECT_EQ('M', reply.records[0].type);
  EXPECT_EQ(packet, packets(reply)[0].payload);
}

TEST_F(BoardOverhearing, ends_the_hold_of_a_poll) {
  board.hold(0, 1000);
  EXPECT_FALSE(board.replies());
  board.receive(toOther('a'));
  board.pass(1);
  EXPECT_EQ(1u, packets(board.takeReply()).size());
}

TEST_F(BoardOverhearing, hears_while_the_radio_is_blocked_and_without_an_rf_id) {
  TestBoard blank;
  blank.use();
  blank.start();
  blank.request('R', OFF);
  EXPECT_EQ(Status::OK, blank.request('O', ON).status);
  blank.receive(toOther('a'));
  EXPECT_EQ(1u, packets(blank.poll()).size());
  board.use();
}

TEST_F(BoardOverhearing, tells_nothing_unless_it_is_asked_to) {
  board.receive(toOther('a'));
  EXPECT_EQ(Status::OK, board.request('O', OFF).status);
  EXPECT_TRUE(overheard().empty());
  board.receive(toOther('b'));
  EXPECT_TRUE(overheard().empty());
  board.reboot();
  board.hello();
  board.receive(toOther('c'));
  EXPECT_TRUE(overheard().empty());
  EXPECT_EQ(0u, board.counter(Counter::RADIO_OVERHEARD_DROPPED));
}

TEST_F(BoardOverhearing, tells_each_packet_once_but_again_if_the_reply_was_lost) {
  board.receive(toOther('a'));
  EXPECT_EQ(1u, overheard().size());
  board.receive(toOther('b'));
  EXPECT_EQ(toOther('b'), overheard(REPLY_COMING).at(0).payload);
  EXPECT_EQ(2u, overheard(REPLY_LOST).size());
  EXPECT_TRUE(overheard(REPLY_COMING).empty());
  EXPECT_TRUE(overheard().empty());
  EXPECT_TRUE(overheard(REPLY_LOST).empty());
}

TEST_F(BoardOverhearing, tells_again_after_a_hello) {
  board.receive(toOther('a'));
  EXPECT_EQ(1u, overheard().size());
  board.hello();
  EXPECT_EQ(1u, overheard(REPLY_COMING).size());
}

TEST_F(BoardOverhearing, counts_what_does_not_fit) {
  const size_t fit = javinolib::config::OVERHEARD_BYTES / (RECORD + LONGEST_PACKET);
  const Bytes packet = plain("////", "ROMA", std::string(LONGEST_PACKET - 10, 'x'));
  for (size_t i = 0; i < fit + 2; i++) board.receive(packet);
  EXPECT_EQ(2u, board.counter(Counter::RADIO_OVERHEARD_DROPPED));
}

TEST_F(BoardOverhearing, tells_how_damaged_packets_came) {
  board.radio.mends = true;
  board.radio.arrive(toOther('a'), {30});
  board.pass(20);
  std::set<size_t> many;
  for (size_t bit = 12; bit < 200; bit += 5) many.insert(bit);
  board.radio.arrive(toOther('b'), many);
  board.pass(200);
  const std::vector<Packet> told = overheard();
  ASSERT_EQ(2u, told.size());
  EXPECT_EQ(1, told[0].how);
  EXPECT_EQ(toOther('a'), told[0].payload);
  EXPECT_EQ(2, told[1].how);
  const Bytes sent = toOther('b');
  ASSERT_EQ(sent.size(), told[1].payload.size());
  EXPECT_EQ(Bytes(sent.end() - 4, sent.end()), Bytes(told[1].payload.end() - 4, told[1].payload.end()));
}

TEST_F(BoardOverhearing, refuses_other_bodies) {
  for (const Bytes &body : {Bytes{}, Bytes{2}, Bytes{1, 1}}) {
    EXPECT_EQ(Status::BAD_ARGUMENT, board.request('O', body).status);
  }
}
