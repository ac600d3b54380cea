// A board with the limits that Config.h sets for an ATmega328P.

#include <gtest/gtest.h>

#include "support/Fragments.h"
#include "support/Keys.h"
#include "support/Reference.h"
#include "support/TestBoard.h"

using javinolib::Counter;
using javinolib::Status;

namespace {

const size_t MAX_CONTENT = 67;
const size_t MAX_SEALED_IN_A_PACKET = 53;

std::string text(size_t length) { return "tell;" + std::string(length - 5, 'x'); }

class SmallBoard : public testing::Test {
 protected:
  SmallBoard() {
    board.start("LAMP");
    board.setKey("ROMA", KEY);
  }

  TestBoard board;
};

}  // namespace

TEST_F(SmallBoard, cuts_a_long_name_to_what_fits_a_reply) {
  const std::string name(90, 'n');
  board.board.reset(new javinolib::RadioBoard(javinolib::SerialPort(board.port), name.c_str(), board.radio));
  board.board->begin();
  EXPECT_EQ(84u, 1 + board.hello().body.size());
}

TEST_F(SmallBoard, tells_the_names_of_its_actions_in_parts) {
  const std::vector<std::string> names = {"turnTheLampOn", "turnTheLampOff", std::string(90, 'n'), "go"};
  Bytes all;
  for (const std::string &name : names) {
    board.board->actions().add(F(name.c_str()), [](const javinolib::Arguments &) { return true; });
    all = all + bytesOf(name) + Bytes(1, 0);
  }
  Bytes told;
  while (told.size() < all.size()) {
    const Bytes body = board.request('C', {0, static_cast<uint8_t>(told.size())}).body;
    ASSERT_LT(1u, body.size());
    EXPECT_GE(83u, body.size());
    EXPECT_EQ(4, body[0]);
    told = told + Bytes(body.begin() + 1, body.end());
  }
  EXPECT_EQ(all, told);
}

TEST_F(SmallBoard, has_place_for_one_session_key_and_tells_of_one_frame_without_a_key) {
  EXPECT_EQ(Status::OK, board.request('V', bytesOf("SUPP") + Bytes(16, 1)).status);
  board.receive(sealed(Bytes(16, 1), "LAMP", "SUPP", {0, 0, 5, 0, 1, 2}, "tell;x"));
  ASSERT_EQ(1u, board.messages().size());
  board.pollTaking(0);
  EXPECT_EQ(Status::OK, board.request('V', bytesOf("SUPO") + Bytes(16, 2)).status);
  EXPECT_EQ(Status::BAD_ARGUMENT, board.request('V', bytesOf("SUPP") + Bytes(16, 1)).status);
  EXPECT_EQ(Status::HAS_KEY, board.request('V', bytesOf("ROMA") + Bytes(16, 3)).status);
  board.receive(sealed(Bytes(16, 1), "LAMP", "SUPP", {0, 0, 5, 0, 1, 3}, "tell;x"));
  board.receive(sealed(Bytes(16, 1), "LAMP", "SUPQ", {0, 0, 5, 0, 1, 3}, "tell;x"));
  EXPECT_EQ(std::vector<std::string>{"LAMPSUPP"}, board.poll().texts('N'));
  board.receive(sealed(Bytes(16, 2), "LAMP", "SUPO", {0, 0, 5, 0, 1, 3}, "tell;y"));
  ASSERT_EQ(1u, board.messages().size());
}

TEST_F(SmallBoard, takes_the_longest_content_and_refuses_a_longer_one) {
  EXPECT_EQ(Status::OK, board.transmit("////", "LAMP", text(MAX_CONTENT)).status);
  board.sendNext();
  EXPECT_EQ(Status::TOO_LONG, board.transmit("////", "LAMP", text(MAX_CONTENT + 1)).status);
  EXPECT_EQ(Status::TOO_LONG, board.transmit("ROMA", "LAMP", text(MAX_CONTENT + 1)).status);
  EXPECT_EQ(Status::OK, board.transmit("ROMA", "LAMP", text(MAX_CONTENT)).status);
  EXPECT_EQ("+F", textOf(board.nextSent()).substr(0, 2)) << "it goes in fragments";
}

TEST_F(SmallBoard, refuses_a_packet_that_is_too_long_and_goes_on) {
  EXPECT_TRUE(board.sendRaw(reference::packet(9, reference::frame("++++", "++++", Bytes(85, 'A')))).empty());
  EXPECT_EQ(1u, board.counter(Counter::SERIAL_DAMAGED));
}

TEST_F(SmallBoard, receives_what_fits_a_packet) {
  board.receive(plain("////", "ROMA", text(MAX_CONTENT)));
  ASSERT_EQ(1u, board.messages().size());
  EXPECT_EQ(text(MAX_CONTENT), board.messages()[0].content);
  board.pollTaking(0);
  board.receive(sealed(KEY, "LAMP", "ROMA", {0, 0, 5, 0, 1, 2}, text(MAX_SEALED_IN_A_PACKET)));
  ASSERT_EQ(1u, board.messages().size());
  EXPECT_EQ(text(MAX_SEALED_IN_A_PACKET), board.messages()[0].content);
}

TEST_F(SmallBoard, drops_and_counts_fragments) {
  for (const Bytes &fragment :
       cut(sealed(KEY, "LAMP", "ROMA", {0, 0, 5, 0, 1, 2}, text(MAX_SEALED_IN_A_PACKET + 1)), 7)) {
    board.receive(fragment);
  }
  EXPECT_TRUE(board.messages().empty());
  EXPECT_EQ(2u, board.counter(Counter::RADIO_FRAGMENTS_DROPPED));
}

TEST_F(SmallBoard, tells_all_outcomes_in_one_poll) {
  unsigned accepted = 0;
  while (board.transmit("////", "LAMP", "tell;x").status == Status::OK) {
    accepted++;
    board.sendNext();
  }
  EXPECT_EQ(8u, accepted);
  EXPECT_EQ(accepted, board.poll().texts('T').size());
}

TEST_F(SmallBoard, leaves_counters_out_that_are_zero) {
  const Bytes body = board.request('S').body;
  ASSERT_EQ(10u, body.size()) << "no other has counted";
  EXPECT_EQ(static_cast<uint8_t>(Counter::LOOP_MILLIS), body[0]);
  EXPECT_EQ(static_cast<uint8_t>(Counter::SERIAL_REQUESTS), body[5]);
}

TEST_F(SmallBoard, leaves_the_first_counters_out_where_not_all_fit) {
  board.radio.counts = {5, 6, 7, 17, 28, 41, 0, 43};
  const Bytes good = sealed(KEY, "LAMP", "ROMA", {0, 0, 5, 0, 1, 2}, "tell;x");
  for (const Bytes &packet :
       {bytesOf("x"), plain("+AAA", "ROMA", "x"), plain("SUPO", "ROMA", "x"), plain("////", "LAMP", "x"),
        sealed(KEY, "LAMP", "SUPO", {0, 0, 5, 0, 1, 2}, "tell;x"),
        sealed(Bytes(16, 9), "LAMP", "ROMA", {0, 0, 5, 0, 1, 2}, "tell;x"), plain("+FAA", "ROMA", "x"), good, good}) {
    board.receive(packet);
  }
  EXPECT_EQ(80u, board.request('S').body.size());
  EXPECT_EQ(43u, board.counter(Counter::AIRTIME_WAIT));
  EXPECT_THROW(board.counter(Counter::SERIAL_REQUESTS), std::runtime_error);
}

// Its lengths are of one byte: a packet of 256 bytes, or of 269, is none of 0 or 13.
TEST(SmallBoardWithoutRadio, takes_packets_of_255_bytes_and_counts_longer_ones_as_damaged) {
  static const size_t LONGEST = 242;
  static std::string argument;
  PlainBoard board;
  board.hello();
  board.board->actions().add(F("say"), [](const javinolib::Arguments &arguments) {
    char text[LONGEST];
    argument = arguments.text(0, text, sizeof text) ? text : "";
    return true;
  });
  uint32_t damaged = 0;
  for (size_t length = LONGEST - 20; length <= 511; length++) {
    const std::string said(length - std::string("Asay()").size(), 'x');
    const Bytes message = bytesOf("Asay(" + said + ")");
    argument.clear();
    if (length <= LONGEST) {
      EXPECT_EQ(Status::OK, board.request(message).status) << length;
      EXPECT_EQ(said, argument);
    } else {
      EXPECT_TRUE(board.sendRaw(reference::packet(9, reference::frame("++++", "++++", message))).empty()) << length;
      EXPECT_EQ("", argument) << length;
      EXPECT_EQ(++damaged, board.counter(Counter::SERIAL_DAMAGED)) << length;
    }
  }
}

TEST(SmallBoardWithoutRadio, tells_percepts_up_to_the_last_byte_of_a_packet) {
  static const size_t LONGEST = 242 - 2 - 3;
  static std::string literal;
  PlainBoard board;
  board.hello();
  board.board->poll().setSource([](javinolib::Percepts &percepts) { percepts.literal(literal.c_str()); });
  for (size_t length :
       {LONGEST - 1, LONGEST, LONGEST + 1, LONGEST + 2, LONGEST + 13, size_t{256}, size_t{300}, size_t{512}}) {
    literal = std::string(length, 'p');
    const PollReply reply = board.poll(true);
    EXPECT_TRUE(reply.reading) << length;
    EXPECT_EQ(length > LONGEST, reply.leftOut) << length;
    EXPECT_EQ(length > LONGEST ? std::vector<std::string>() : std::vector<std::string>{literal}, reply.texts('P'));
  }
}

TEST_F(SmallBoard, stays_whole_whatever_comes_from_host_and_air) {
  RandomBytes random(57);
  for (int i = 0; i < 3000; i++) {
    const char *destinations[] = {"++++", "////", "//ZZ", "ROMA", "+FAA", "LAMP"};
    const std::string destination = destinations[random.number(6)];
    const Bytes message = random.bytes(random.number(120));
    const size_t replies =
        board.sendRaw(reference::packet(random.byte(), reference::frame(destination, "LAMP", message))).size();
    EXPECT_EQ(message.size() <= 84 ? 1u : 0u, replies) << message.size();
    Bytes frame = reference::frame(destinations[random.number(6)], "ROMA", random.bytes(6 + random.number(62)));
    if (random.number(3) == 0) frame[8 + random.number(2)] = static_cast<uint8_t>("A/x+8w"[random.number(6)]);
    board.receive(frame);
    board.pollTaking(random.byte());
  }
  EXPECT_EQ(Status::OK, board.hello().status);
}
