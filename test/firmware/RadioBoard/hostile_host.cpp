#include <Arduino.h>
#include <gtest/gtest.h>

#include "support/CommandLetters.h"
#include "support/Keys.h"
#include "support/Reference.h"
#include "support/TestBoard.h"

namespace {

// All secrets that the board has or had.
std::vector<Bytes> secrets() {
  javinolib::DerivedKeys keys;
  keys.derive(KEY.data());
  return {KEY, Bytes(keys.encryption, keys.encryption + 16), Bytes(keys.authentication, keys.authentication + 16)};
}

}  // namespace

TEST(RadioBoard, keys_are_in_no_byte_that_it_ever_writes_whatever_the_host_asks) {
  TestBoard board;
  board.start("SUPP");
  board.board->poll().setSource([](javinolib::Percepts &percepts) { percepts.add(F("dark")); });
  board.setKey("SUHO", KEY);
  RandomBytes random(15);
  const std::string commands = commandLetters() + "ZX";
  for (int i = 0; i < 5000; i++) {
    Bytes message = random.bytes(random.number(40));
    if (!message.empty()) message[0] = static_cast<uint8_t>(commands[random.number(commands.size())]);
    board.request(message);
  }
  Bytes everything = board.port.everWritten();
  for (const Bytes &packet : board.radio.sent) everything = everything + packet;
  for (const Bytes &secret : secrets()) {
    EXPECT_FALSE(contains(everything, secret));
    for (size_t at = 0; at + 4 <= secret.size(); at++) {
      EXPECT_FALSE(contains(everything, Bytes(secret.begin() + at, secret.begin() + at + 4))) << at;
    }
  }
}

TEST(RadioBoard, random_packets_get_one_reply_each_and_never_break_it) {
  TestBoard board;
  board.start("SUPP");
  RandomBytes random(16);
  for (int i = 0; i < 5000; i++) {
    const char *destinations[] = {"++++", "////", "//SU", "SUHO", "+FAA"};
    const std::string destination = destinations[random.number(5)];
    const Bytes message = random.bytes(random.number(512));
    EXPECT_EQ(1u,
              board.sendRaw(reference::packet(random.byte(), reference::frame(destination, "SUPP", message))).size());
  }
}

TEST(RadioBoard, random_bytes_are_answered_with_silence) {
  TestBoard board;
  board.start("SUPP");
  RandomBytes random(17);
  for (int i = 0; i < 1000; i++) EXPECT_TRUE(board.sendRaw(random.bytes(random.number(700)) + Bytes{0}).empty());
}
