#include <Arduino.h>
#include <gtest/gtest.h>
#include <storage/EepromLayout.h>

#include "support/CommandLetters.h"
#include "support/Keys.h"
#include "support/Reference.h"
#include "support/StoredRecord.h"
#include "support/TestBoard.h"
#include "support/Vectors.h"

using javinolib::Status;

namespace {

const Bytes KEY_CHECK = fromHex("dcc75b");

Status statusOf(const std::string &name) {
  const struct {
    const char *name;
    Status status;
  } all[] = {{"UNKNOWN_COMMAND", Status::UNKNOWN_COMMAND},
             {"BAD_ARGUMENT", Status::BAD_ARGUMENT},
             {"BAD_DESTINATION", Status::BAD_DESTINATION},
             {"NO_KEY", Status::NO_KEY}};
  for (const auto &entry : all) {
    if (name == entry.name) return entry.status;
  }
  throw std::runtime_error("the test knows no status " + name);
}

class BoardStatus : public testing::Test {
 protected:
  BoardStatus() {
    board.radio.mends = true;  // so it can be a relay
    board.start("ROMA");
  }

  TestBoard board;
};

}  // namespace

TEST_F(BoardStatus, refuses_all_bad_requests_of_the_vectors) {
  for (const Vector &vector : vectors("commands.json", "badRequests")) {
    SCOPED_TRACE(vector.toString());
    const BoardReply reply = board.request(vector.bytes("message"));
    EXPECT_EQ(statusOf(vector.text("status")), reply.status);
    EXPECT_TRUE(reply.body.empty());
  }
}

TEST_F(BoardStatus, understands_all_requests_of_the_vectors) {
  board.board->actions().add(F("stop"), [](const javinolib::Arguments &) { return true; });
  board.board->actions().add(F("goTo"), [](const javinolib::Arguments &) { return true; });
  for (const Vector &vector : vectors("commands.json", "requests")) {
    SCOPED_TRACE(vector.toString());
    if (vector.text("name") == "transmit") continue;
    EXPECT_EQ(Status::OK, board.request(vector.bytes("message")).status);
    board.passSending(20000);
  }
}

TEST_F(BoardStatus, raises_no_epoch_while_a_message_is_under_way_or_waits) {
  board.setKey("SUPO", KEY);
  for (const char *to : {"////", "SUPO", "SUPO"}) board.transmit(to, "ROMA", "tell;x");
  EXPECT_EQ(Status::BUSY, board.request('E', {0, 1, 0}).status);
  board.passSending(120000);
  EXPECT_EQ(Status::OK, board.request('E', {0, 1, 0}).status);
}

TEST_F(BoardStatus, transmits_the_requests_of_the_vectors) {
  for (const Vector &vector : vectors("commands.json", "requests")) {
    if (vector.text("name") != "transmit") continue;
    SCOPED_TRACE(vector.toString());
    board.request('I', bytesOf(vector.text("origin")));
    if (vector.text("destination") != "////") board.setKey(vector.text("destination"), KEY);
    EXPECT_EQ(Status::OK,
              board.transmit(vector.text("destination"), vector.text("origin"), vector.text("content")).status);
    board.passSending(20000);
    board.poll();
  }
}

TEST_F(BoardStatus, answers_UNKNOWN_COMMAND_to_every_other_command_byte) {
  for (int command = 0; command < 256; command++) {
    if (commandLetters().find(static_cast<char>(command)) != std::string::npos) continue;
    EXPECT_EQ(Status::UNKNOWN_COMMAND, board.request(Bytes(1, static_cast<uint8_t>(command))).status) << command;
  }
  EXPECT_EQ(Status::UNKNOWN_COMMAND, board.request(Bytes()).status);
}

TEST_F(BoardStatus, answers_BAD_ARGUMENT_to_bodies_that_a_command_does_not_take) {
  board.board->actions().add(F("go"), [](const javinolib::Arguments &) { return true; });
  for (const std::string &message : {std::string("H"), std::string("H\1\1"), std::string("L1"), std::string("S1"),
                                     std::string("P\2"), std::string("A"), std::string("Astop("), std::string("D////"),
                                     std::string("D++++"), std::string("IROM"), std::string("K")}) {
    EXPECT_EQ(Status::BAD_ARGUMENT, board.request(bytesOf(message)).status) << message;
  }
}

TEST_F(BoardStatus, answers_UNKNOWN_ACTION_and_ACTION_FAILED) {
  board.board->actions().add(F("refuse"), [](const javinolib::Arguments &) { return false; });
  EXPECT_EQ(Status::UNKNOWN_ACTION, board.request(bytesOf("Afly")).status);
  EXPECT_EQ(Status::ACTION_FAILED, board.request(bytesOf("Arefuse")).status);
}

TEST_F(BoardStatus, hands_arguments_to_the_action) {
  static long speed;
  board.board->actions().add(F("speed"),
                             [](const javinolib::Arguments &arguments) { return arguments.integer(0, speed); });
  EXPECT_EQ(Status::OK, board.request(bytesOf("Aspeed(-12)")).status);
  EXPECT_EQ(-12, speed);
}

TEST(RadioBoard, answers_NO_RF_ID_before_one_is_set) {
  TestBoard board;
  board.start();
  EXPECT_EQ(Status::NO_RF_ID, board.transmit("////", "ROMA", "tell;help").status);
}

TEST_F(BoardStatus, answers_WRONG_ORIGIN) {
  EXPECT_EQ(Status::WRONG_ORIGIN, board.transmit("////", "SUPO", "tell;help").status);
  EXPECT_EQ(Status::WRONG_ORIGIN, board.transmit("////", "++++", "tell;help").status);
  EXPECT_EQ(Status::WRONG_ORIGIN, board.exchange(reference::frame("++++", "ROMA", bytesOf("L"))).status);
  EXPECT_EQ(Status::WRONG_ORIGIN, board.exchange(reference::frame("++++", "////", bytesOf("L"))).status);
}

TEST_F(BoardStatus, answers_BAD_DESTINATION) {
  for (const char *destination : {"ROMA", "+FAA", "+KAA", "/AAA", "/+//", "+++/"}) {
    EXPECT_EQ(Status::BAD_DESTINATION, board.transmit(destination, "ROMA", "tell;help").status) << destination;
  }
}

TEST_F(BoardStatus, answers_NO_KEY) {
  EXPECT_EQ(Status::NO_KEY, board.transmit("SUPO", "ROMA", "tell;help").status);
  EXPECT_EQ(Status::NO_KEY, board.transmit("//SU", "ROMA", "tell;help").status);
  EXPECT_EQ(Status::NO_KEY, board.request(bytesOf("DSUPO")).status);
}

TEST_F(BoardStatus, answers_TOO_LONG_beyond_494_bytes) {
  board.setKey("SUPO", KEY);
  for (const char *destination : {"////", "SUPO"}) {
    EXPECT_EQ(Status::TOO_LONG, board.transmit(destination, "ROMA", std::string(495, 'x')).status);
    EXPECT_EQ(Status::TOO_LONG, board.transmit(destination, "ROMA", std::string(511, 'x')).status);
    EXPECT_EQ(Status::OK, board.transmit(destination, "ROMA", std::string(494, 'x')).status);
    board.passSending(60000);
    EXPECT_EQ(1u, board.poll().texts('T').size());
  }
}

TEST_F(BoardStatus, answers_QUEUE_FULL_to_what_finds_no_room_and_takes_it_later) {
  int accepted = 0;
  while (board.transmit("////", "ROMA", std::string(90, 'x')).status == Status::OK) accepted++;
  EXPECT_EQ(javinolib::config::TRANSMIT_BYTES / (3 + 10 + 90), accepted);
  EXPECT_EQ(Status::QUEUE_FULL, board.transmit("////", "ROMA", std::string(90, 'x')).status);
  EXPECT_EQ(Status::OK, board.transmit("////", "ROMA", "tell;help").status) << "a shorter one still fits";
  board.sendNext();
  board.sendNext();
  EXPECT_EQ(Status::OK, board.transmit("////", "ROMA", std::string(90, 'x')).status);
}

TEST_F(BoardStatus, answers_STORE_FULL) {
  for (int i = 0; i < javinolib::config::KEYS; i++) {
    EXPECT_EQ(KEY_CHECK, board.setKey("AA" + std::string(1, static_cast<char>('A' + i)) + "A", KEY).body);
  }
  EXPECT_EQ(Status::STORE_FULL, board.setKey("SUPO", KEY).status);
  board.request(bytesOf("DAACA"));
  EXPECT_EQ(Status::OK, board.setKey("SUPO", KEY).status);
  EXPECT_EQ(16u * 8, board.request('L').body.size());
}

TEST_F(BoardStatus, answers_STORE_FAILED) {
  for (uint16_t at = 0; at < 4096; at++) board.eeprom.wearOut(at);
  EXPECT_EQ(Status::STORE_FAILED, board.setKey("SUPO", KEY).status);
  EXPECT_EQ(Status::STORE_FAILED, board.request(bytesOf("ISUPO")).status);
}

TEST_F(BoardStatus, seals_nothing_where_the_boot_epoch_could_not_be_stored) {
  board.setKey("SUPO", KEY);
  for (uint16_t i = 0; i < javinolib::EPOCHS_LENGTH; i++) {
    board.eeprom.wearOut(static_cast<uint16_t>(javinolib::EPOCHS_AT + i));
    board.eeprom.wearOut(static_cast<uint16_t>(javinolib::OTHER_EPOCHS_AT + i));
  }
  EXPECT_FALSE(board.reboot());
  board.hello();
  EXPECT_EQ(Status::STORE_FAILED, board.transmit("SUPO", "ROMA", "tell;help").status);
  EXPECT_EQ(Status::OK, board.transmit("////", "ROMA", "tell;help").status);
}

TEST_F(BoardStatus, answers_NONCE_EXHAUSTED) {
  board.setKey("SUPO", KEY);
  StoredRecord(javinolib::EPOCHS_AT, 3).write(fromHex("fffffe"));
  board.reboot();
  board.hello();
  EXPECT_EQ(Status::NONCE_EXHAUSTED, board.transmit("SUPO", "ROMA", "tell;help").status);
  EXPECT_EQ(Status::OK, board.transmit("////", "ROMA", "tell;help").status) << "a broadcast needs no nonce";
}

TEST_F(BoardStatus, opens_and_blocks_the_radio) {
  board.reboot();
  board.hello();
  board.receive(plain("////", "SUPO", "tell;1"));
  EXPECT_TRUE(board.messages().empty()) << "boards start with the radio blocked";
  board.request('R', {1});
  board.receive(plain("////", "SUPO", "tell;2"));
  EXPECT_EQ(1u, board.messages().size());
  board.request('R', {0});
  board.receive(plain("////", "SUPO", "tell;3"));
  EXPECT_EQ(1u, board.messages().size());
  board.request('R', {1});
  EXPECT_EQ(1u, board.messages().size()) << "what came meanwhile is lost";
}
