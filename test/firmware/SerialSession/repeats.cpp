#include <Arduino.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "support/Reference.h"
#include "support/TestBoard.h"

using javinolib::Counter;
using javinolib::Status;

namespace {

int performed;

bool count(const javinolib::Arguments &) {
  performed++;
  return true;
}

class SerialSessionTest : public testing::Test {
 protected:
  SerialSessionTest() {
    performed = 0;
    board.start();
    board.board->actions().add(F("count"), count);
  }

  Bytes request(uint8_t sequence, const std::string &message) {
    return reference::packet(sequence, reference::frame("++++", "++++", bytesOf(message)));
  }

  TestBoard board;
};

}  // namespace

TEST_F(SerialSessionTest, a_repeat_is_answered_from_memory_and_performed_once) {
  const std::vector<Bytes> first = board.sendRaw(request(100, "Acount"));
  for (int i = 0; i < 5; i++) EXPECT_EQ(first, board.sendRaw(request(100, "Acount")));
  EXPECT_EQ(1, performed);
  EXPECT_EQ(5u, board.counter(Counter::SERIAL_REPEATS));
}

TEST_F(SerialSessionTest, a_repeat_of_an_action_with_a_number_is_answered_with_that_number) {
  static long next;
  next = -3;
  board.board->actions().addResult(
      F("next"), [](const javinolib::Arguments &, javinolib::Result &result) { return result.number(next++); });
  const std::vector<Bytes> first = board.sendRaw(request(100, "Anext"));
  for (int i = 0; i < 5; i++) EXPECT_EQ(first, board.sendRaw(request(100, "Anext")));
  EXPECT_EQ(-2, next);
  EXPECT_NE(first, board.sendRaw(request(101, "Anext")));
}

TEST_F(SerialSessionTest, a_repeat_is_known_after_damaged_ones) {
  const Bytes good = request(100, "Acount");
  const std::vector<Bytes> first = board.sendRaw(good);
  for (size_t at = 0; at < good.size(); at++) {
    Bytes damaged = good;
    damaged[at] = static_cast<uint8_t>(damaged[at] ^ 0x10);
    board.sendRaw(damaged + Bytes{0} + Bytes(600, 0x55) + Bytes{0});
    ASSERT_EQ(first, board.sendRaw(good)) << at;
  }
  EXPECT_EQ(1, performed);
}

TEST_F(SerialSessionTest, takes_the_longest_request_while_it_sends_the_longest_reply) {
  board.board->poll().setSource([](javinolib::Percepts &percepts) {
    for (int i = 0; i < 200; i++) percepts.add(F("n"), i);
  });
  const Bytes poll = request(7, std::string("P\3\0\0\0\0\0", 7));
  const std::vector<Bytes> alone = board.sendRaw(poll);
  ASSERT_LT(javinolib::MAX_PACKET_LENGTH - 10, reference::cobsDecoded(alone[0]).size());
  const Bytes action = request(8, "Acount(\"" + std::string(javinolib::MAX_MESSAGE_LENGTH - 10, 'x') + "\")");
  board.port.setRoom(0);
  board.port.arrive(poll);
  board.board->run();
  Bytes written;
  for (size_t i = 0; i < 2 * javinolib::MAX_PACKET_LENGTH; i++) {
    if (i < action.size()) board.port.arrive({action[i]});
    board.port.setRoom(1);
    board.board->run();
    written = written + board.port.takeWritten();
    ASSERT_EQ(0, performed * (written.size() <= alone[0].size())) << "before the reply is out";
  }
  EXPECT_EQ(1, performed);
  EXPECT_TRUE(std::equal(alone[0].begin(), alone[0].end(), written.begin() + 2)) << "behind the zeros";
  board.port.setRoom(SIZE_MAX);
  EXPECT_EQ(0u, board.counter(Counter::SERIAL_DAMAGED));
}

TEST_F(SerialSessionTest, another_sequence_or_another_request_is_no_repeat) {
  board.sendRaw(request(100, "Acount"));
  board.sendRaw(request(101, "Acount"));
  board.sendRaw(request(101, "Acount(1)"));
  board.sendRaw(request(100, "Acount"));
  EXPECT_EQ(4, performed);
}

TEST_F(SerialSessionTest, the_sequence_byte_is_echoed_for_all_its_values) {
  for (int sequence = 0; sequence < 256; sequence++) {
    const std::vector<Bytes> replies = board.sendRaw(request(static_cast<uint8_t>(sequence), "L"));
    ASSERT_EQ(1u, replies.size());
    EXPECT_EQ(sequence, reference::cobsDecoded(replies[0])[0]);
  }
}

TEST_F(SerialSessionTest, every_chunk_size_gives_the_same_replies) {
  const Bytes bytes = request(1, "Acount") + request(2, "L") + request(3, "S") + request(4, "Acount(2)");
  for (size_t step = 1; step <= bytes.size(); step++) {
    TestBoard other;
    other.start();
    other.board->actions().add(F("count"), count);
    performed = 0;
    std::vector<Bytes> replies;
    for (size_t at = 0; at < bytes.size(); at += step) {
      const size_t end = std::min(at + step, bytes.size());
      for (const Bytes &reply : other.sendRaw(Bytes(bytes.begin() + at, bytes.begin() + end))) replies.push_back(reply);
    }
    ASSERT_EQ(4u, replies.size()) << step;
    ASSERT_EQ(2, performed) << step;
  }
}

TEST_F(SerialSessionTest, a_reply_goes_out_in_whatever_fragments_the_line_takes) {
  board.port.setRoom(0);
  board.port.arrive(request(1, "S") + request(2, "Acount"));
  board.board->run();
  EXPECT_EQ(0, performed);
  EXPECT_TRUE(board.board->isIdle()) << "there is nothing to do until the line takes bytes again";
  Bytes written;
  for (int i = 0; i < 300; i++) {
    board.port.setRoom(1);
    board.board->run();
    written = written + board.port.takeWritten();
  }
  EXPECT_EQ(6, std::count(written.begin(), written.end(), 0)) << "two before and one behind each reply";
  EXPECT_EQ(1, performed);
}

TEST_F(SerialSessionTest, says_that_a_request_has_come_before_it_performs_it) {
  static TestBoard *current;
  current = &board;
  board.board->actions().add(F("look"), [](const javinolib::Arguments &) {
    EXPECT_EQ(Bytes{0}, current->port.written());
    performed++;
    return true;
  });
  board.sendRaw(request(1, "Alook"));
  EXPECT_EQ(1, performed);
  board.sendRaw(request(1, "Alook"));
  board.port.arrive(request(1, "Alook"));
  board.board->run();
  EXPECT_EQ(0, board.port.written().front()) << "also of a repeat";
}

TEST_F(SerialSessionTest, performs_no_request_before_it_can_say_that_it_has_come) {
  board.port.setRoom(0);
  board.port.arrive(request(1, "Acount"));
  board.board->run();
  EXPECT_EQ(0, performed);
  EXPECT_TRUE(board.board->isIdle());
  board.port.setRoom(1);
  EXPECT_FALSE(board.board->isIdle());
  board.board->run();
  EXPECT_EQ(1, performed);
  EXPECT_EQ(Bytes{0}, board.port.takeWritten());
}

TEST_F(SerialSessionTest, what_a_sketch_prints_ends_before_the_reply) {
  for (uint8_t byte : bytesOf("x = 3\r\n")) board.port.put(byte);
  const std::vector<Bytes> packets = board.sendRaw(request(1, "Acount"));
  ASSERT_EQ(2u, packets.size());
  EXPECT_EQ("x = 3\r\n", textOf(packets[0]));
  EXPECT_EQ(1, reference::cobsDecoded(packets[1])[0]);
}

TEST_F(SerialSessionTest, what_a_sketch_prints_while_a_poll_is_held_ends_before_the_reply) {
  board.hold(0, 100);
  board.port.takeWritten();
  for (uint8_t byte : bytesOf("x = 3\r\n")) board.port.put(byte);
  const std::vector<Bytes> packets = board.sendRaw({0});
  ASSERT_EQ(2u, packets.size());
  EXPECT_EQ("x = 3\r\n", textOf(packets[0]));
}

TEST_F(SerialSessionTest, is_not_idle_while_bytes_wait) {
  EXPECT_TRUE(board.board->isIdle());
  board.port.arrive({1});
  EXPECT_FALSE(board.board->isIdle());
}

TEST_F(SerialSessionTest, damage_is_counted_and_not_answered) {
  Bytes damaged = request(1, "Acount");
  damaged[5] = static_cast<uint8_t>(damaged[5] ^ 0x10);
  EXPECT_TRUE(board.sendRaw(damaged).empty());
  EXPECT_TRUE(board.sendRaw({2, 0}).empty());
  EXPECT_TRUE(board.sendRaw({2, 1, 0}).empty());
  EXPECT_TRUE(board.sendRaw(Bytes(600, 0x55) + Bytes{0}).empty());
  EXPECT_EQ(0, performed);
  EXPECT_EQ(4u, board.counter(Counter::SERIAL_DAMAGED));
}

TEST_F(SerialSessionTest, what_a_host_says_to_a_boot_loader_until_it_is_greeted_is_no_damage) {
  board.sendRaw({0x1B, 0x01, 0x00, 0x01, 0x0E, 0x11, 0x04, 0});
  board.hello();
  EXPECT_EQ(0u, board.counter(Counter::SERIAL_DAMAGED));
  board.sendRaw({2, 1, 0});
  EXPECT_EQ(1u, board.counter(Counter::SERIAL_DAMAGED));
}

TEST_F(SerialSessionTest, damage_has_the_host_ask_again_but_not_within_a_reply) {
  board.port.arrive({2, 1, 0});
  board.board->run();
  EXPECT_EQ((Bytes{0, 1, 0}), board.port.takeWritten());
  board.port.setRoom(5);
  board.port.arrive(request(1, "Acount"));
  board.port.arrive({2, 1, 0});
  board.board->run();
  board.port.setRoom(SIZE_MAX);
  board.board->run();
  const Bytes reply = board.port.takeWritten();
  EXPECT_EQ(3, std::count(reply.begin(), reply.end(), 0)) << "twice before it, and behind it";
  EXPECT_EQ(2u, board.counter(Counter::SERIAL_DAMAGED));
}

TEST_F(SerialSessionTest, packets_that_hold_no_frame_are_counted_and_not_answered) {
  EXPECT_TRUE(board.sendRaw(reference::packet(1, bytesOf("++++++++AB"))).empty());
  EXPECT_TRUE(board.sendRaw(reference::packet(1, bytesOf("++++++++AI"))).empty());
  EXPECT_TRUE(board.sendRaw(reference::packet(1, bytesOf("++++++-+AA"))).empty());
  EXPECT_EQ(3u, board.counter(Counter::SERIAL_BAD_FRAMES));
  EXPECT_EQ(0u, board.counter(Counter::SERIAL_DAMAGED));
}

TEST_F(SerialSessionTest, a_noisy_line_performs_nothing_twice_and_answers_only_what_came_whole) {
  RandomBytes random(12);
  for (int round = 0; round < 1000; round++) {
    const uint8_t sequence = static_cast<uint8_t>(round);
    const Bytes good = request(sequence, "Acount(" + std::to_string(round) + ")");
    const int before = performed;
    Bytes noisy = good;
    const uint32_t at = random.number(static_cast<uint32_t>(noisy.size()));
    switch (random.number(3)) {
      case 0: noisy[at] = static_cast<uint8_t>(noisy[at] ^ 1 << random.number(8)); break;
      case 1: noisy.erase(noisy.begin() + at); break;
      default: noisy.insert(noisy.begin() + at, random.byte());
    }
    board.sendRaw(noisy + Bytes{0});
    board.sendRaw(good);
    board.sendRaw(good);
    ASSERT_EQ(before + 1, performed) << toHex(noisy);
  }
}
