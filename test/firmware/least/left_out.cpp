// A board without all that Config.h can leave out.

#include <gtest/gtest.h>

#include "support/Fragments.h"
#include "support/Reference.h"
#include "support/TestBoard.h"

using javinolib::Status;

namespace {

const Bytes KEY = fromHex("000102030405060708090a0b0c0d0e0f");
const Bytes OTHER_KEY = fromHex("101112131415161718191a1b1c1d1e1f");
const Bytes ROMA = bytesOf("ROMA");
const size_t MAX_SEALED_IN_A_PACKET = 53;

class LeastBoard : public testing::Test {
 protected:
  LeastBoard() {
    board.start("LAMP");
    board.setKey("ROMA", KEY);
  }

  TestBoard board;
};

}  // namespace

TEST_F(LeastBoard, does_not_know_the_commands_that_are_left_out) {
  EXPECT_EQ(Status::UNKNOWN_COMMAND, board.request('N', ROMA + OTHER_KEY).status);
  EXPECT_EQ(Status::UNKNOWN_COMMAND, board.request('U', ROMA).status);
  EXPECT_EQ(Status::UNKNOWN_COMMAND, board.request('F', ROMA).status);
  EXPECT_EQ(Status::UNKNOWN_COMMAND, board.request('V', ROMA + OTHER_KEY).status);
  EXPECT_EQ(Status::UNKNOWN_COMMAND, board.request('S').status);
  EXPECT_EQ(Status::UNKNOWN_COMMAND, board.request('O', {1}).status);
  EXPECT_EQ(Status::UNKNOWN_COMMAND, board.request('Y', plain("////", "ROMA", "tell;x")).status);
}

TEST_F(LeastBoard, has_no_action) {
  EXPECT_FALSE(board.board->action(F("go"), [](const javinolib::Arguments &) { return true; }));
  EXPECT_EQ(Status::UNKNOWN_ACTION, board.request('A', bytesOf("go")).status);
  EXPECT_EQ(Bytes(1, 0), board.request('C', {0, 0}).body);
}

TEST_F(LeastBoard, replaces_and_deletes_keys) {
  EXPECT_EQ(Status::OK, board.setKey("ROMA", OTHER_KEY).status);
  const size_t entry = 4 + 1 + 3;
  EXPECT_EQ(entry, board.request('L').body.size());
  board.receive(sealed(KEY, "LAMP", "ROMA", {0, 0, 5, 0, 1, 2}, "tell;x"));
  EXPECT_TRUE(board.messages().empty());
  board.receive(sealed(OTHER_KEY, "LAMP", "ROMA", {0, 0, 5, 0, 1, 3}, "tell;y"));
  ASSERT_EQ(1u, board.messages().size());
  EXPECT_EQ("tell;y", board.messages()[0].content);
  EXPECT_EQ(Status::OK, board.request('D', ROMA).status);
  EXPECT_TRUE(board.request('L').body.empty());
}

TEST_F(LeastBoard, tells_nothing_of_frames_without_a_key) {
  board.receive(sealed(KEY, "LAMP", "SUPP", {0, 0, 5, 0, 1, 2}, "tell;x"));
  EXPECT_TRUE(board.poll().records.empty());
}

TEST_F(LeastBoard, drops_fragments_and_sends_them) {
  const std::string content(MAX_SEALED_IN_A_PACKET + 1, 'x');
  for (const Bytes &fragment : cut(sealed(KEY, "LAMP", "ROMA", {0, 0, 5, 0, 1, 2}, content), 7))
    board.receive(fragment);
  EXPECT_TRUE(board.messages().empty());
  EXPECT_EQ(Status::OK, board.transmit("ROMA", "LAMP", content).status);
  EXPECT_EQ("+F", textOf(board.nextSent()).substr(0, 2));
}
