#include <gtest/gtest.h>

#include "support/Keys.h"
#include "support/TestBoard.h"

using javinolib::Status;

namespace {

// A board SUHO that sends what its host has from elsewhere.
class BoardRelaying : public testing::Test {
 protected:
  BoardRelaying() {
    board.start("SUHO");
    board.setKey("SUPO", KEY);
  }

  // The outcomes that a poll tells: number and outcome, each two digits.
  std::vector<Bytes> outcomes() {
    std::vector<Bytes> all;
    for (const PollRecord &record : board.poll().records) {
      if (record.type == 'T') all.push_back(record.value);
    }
    return all;
  }

  TestBoard board;
};

}  // namespace

TEST_F(BoardRelaying, sends_a_frame_of_any_origin_once_and_byte_by_byte) {
  const std::vector<Bytes> all = {sealed(OTHER_KEY, "SUPO", "ROMA", {0, 0, 1, 0, 0, 9}, "tell;x"),
                                  sealed(OTHER_KEY, "//SU", "ROMA", {0, 0, 1, 0, 0, 10}, "tell;x"),
                                  plain("////", "ROMA", "tell;x"),
                                  plain("+KAA", "ROMA", "12345678"),
                                  plain("+FAA", "ROMA", std::string(67, 'x')),
                                  plain("SUHO", "ROMA", "")};
  uint8_t number = 0;
  for (const Bytes &frame : all) {
    const BoardReply reply = board.request('Y', frame);
    EXPECT_EQ(Status::OK, reply.status);
    EXPECT_EQ(Bytes{number}, reply.body);
    EXPECT_EQ(frame, board.sendNext());
    EXPECT_EQ((std::vector<Bytes>{{number, 0}}), outcomes());
    number++;
  }
  const size_t sent = board.radio.sent.size();
  board.passSending(5000);
  EXPECT_EQ(sent, board.radio.sent.size());
}

TEST_F(BoardRelaying, waits_while_it_hears_a_carrier) {
  board.radio.heard = true;
  board.request('Y', plain("////", "ROMA", "tell;x"));
  board.pass(1000);
  EXPECT_TRUE(board.radio.sent.empty());
  board.radio.heard = false;
  board.sendNext();
}

TEST_F(BoardRelaying, needs_neither_rf_id_nor_key_nor_open_radio) {
  TestBoard blank;
  blank.use();
  blank.start();
  blank.request('R', Bytes{0});
  const Bytes frame = sealed(KEY, "SUPO", "ROMA", {0, 0, 1, 0, 0, 9}, "tell;x");
  EXPECT_EQ(Status::OK, blank.request('Y', frame).status);
  EXPECT_EQ(frame, blank.sendNext());
  board.use();
}

TEST_F(BoardRelaying, keeps_what_it_relays_apart_from_its_own_messages) {
  const Bytes frame = sealed(OTHER_KEY, "SUPO", "ROMA", {0, 0, 1, 0, 0, 9}, "tell;x");
  board.request('Y', frame);
  board.transmit("SUPO", "SUHO", "tell;y");
  // An acknowledgement of what was relayed concerns another board.
  EXPECT_EQ(frame, board.sendNext());
  EXPECT_EQ("SUPOSUHO", textOf(board.sendNext()).substr(0, 8));
  board.passSending(20000);
  EXPECT_EQ((std::vector<Bytes>{{0, 0}, {1, 2}}), outcomes());
}

TEST_F(BoardRelaying, goes_on_with_its_own_messages_under_a_new_rf_id) {
  board.transmit("SUPO", "SUHO", "tell;y");
  board.request('I', bytesOf("SUAM"));
  EXPECT_EQ("SUPOSUHO", textOf(board.sendNext()).substr(0, 8));
  EXPECT_EQ(std::string::npos, textOf(board.radio.sent[0]).find("tell;y"));
}

TEST_F(BoardRelaying, refuses_what_is_no_packet_of_another_device) {
  EXPECT_EQ(Status::BAD_ARGUMENT, board.request('Y').status);
  EXPECT_EQ(Status::BAD_ARGUMENT, board.request('Y', bytesOf("////ROMAAB")).status);
  EXPECT_EQ(Status::BAD_ARGUMENT, board.request('Y', plain("////", "++++", "x")).status);
  EXPECT_EQ(Status::BAD_ARGUMENT, board.request('Y', plain("////", "//SU", "x")).status);
  EXPECT_EQ(Status::WRONG_ORIGIN, board.request('Y', plain("////", "SUHO", "x")).status);
  EXPECT_EQ(Status::BAD_DESTINATION, board.request('Y', plain("++++", "ROMA", "x")).status);
  EXPECT_EQ(Status::BAD_DESTINATION, board.request('Y', plain("+AAA", "ROMA", "x")).status);
  EXPECT_EQ(Status::TOO_LONG, board.request('Y', plain("////", "ROMA", std::string(68, 'x'))).status);
  board.passSending(1000);
  EXPECT_TRUE(board.radio.sent.empty());
}

TEST_F(BoardRelaying, says_when_the_queue_is_full) {
  const Bytes frame = plain("////", "ROMA", std::string(67, 'x'));
  Status status;
  int taken = 0;
  while ((status = board.request('Y', frame).status) == Status::OK) taken++;
  EXPECT_EQ(Status::QUEUE_FULL, status);
  for (int i = 0; i < taken; i++) EXPECT_EQ(frame, board.sendNext());
}
