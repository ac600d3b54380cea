#include <gtest/gtest.h>
#include <storage/EepromLayout.h>

#include <map>

#include "support/Keys.h"
#include "support/ReplayRig.h"
#include "support/TestBoard.h"

using javinolib::Counter;
using javinolib::Status;

namespace {

const uint8_t SEALED_HEAD = 16;  // header and nonce

// A board SUHO that shares keys with SUPP, with ROMA and with its group.
class LostState : public testing::Test {
 protected:
  LostState() {
    board.start("SUHO");
    for (const char *with : {"SUPP", "ROMA", "//SU"}) board.setKey(with, KEY);
  }

  // A sketch takes the places of the epochs for its own.
  void loseEpochs() {
    for (uint16_t i = 0; i < javinolib::EPOCHS_LENGTH; i++) {
      board.eeprom.corrupt(static_cast<uint16_t>(javinolib::EPOCHS_AT + i), 0x33);
      board.eeprom.corrupt(static_cast<uint16_t>(javinolib::OTHER_EPOCHS_AT + i), 0x33);
    }
    board.powerUp();
    board.hello();
    board.request(bytesOf(std::string("R\1", 2)));
    board.pass(1000);
  }

  uint32_t epoch() {
    const Bytes body = board.hello().body;
    return static_cast<uint32_t>(body.at(5) << 16 | body.at(6) << 8 | body.at(7));
  }

  Status raise(uint32_t to) {
    return board.request('E', {static_cast<uint8_t>(to >> 16), static_cast<uint8_t>(to >> 8), static_cast<uint8_t>(to)})
        .status;
  }

  bool takes(const Bytes &packet) {
    board.receive(packet);
    const std::vector<PolledMessage> messages = board.messages();
    if (!messages.empty()) board.pollTaking(messages.back().number);
    board.passSending(2000);
    return !messages.empty();
  }

  // Sends a multicast; no nonce that was used before may seal another one.
  void sendAnew(const std::string &content) {
    ASSERT_EQ(Status::OK, board.transmit("//SU", "SUHO", content).status);
    const Bytes packet = board.sendNext();
    const Bytes nonce(packet.begin() + javinolib::HEADER_LENGTH, packet.begin() + SEALED_HEAD);
    EXPECT_TRUE(sent.emplace(nonce, packet).second) << toHex(nonce) << " came again";
    board.passSending(2000);
  }

  TestBoard board;
  std::map<Bytes, Bytes> sent;
};

}  // namespace

TEST_F(LostState, of_epochs_seals_nothing_before_a_host_has_raised_them) {
  for (uint32_t loss = 1; loss <= 2; loss++) {
    sendAnew("tell;one");
    sendAnew("tell;two");
    loseEpochs();
    EXPECT_EQ(0u, epoch());
    EXPECT_EQ(Status::EPOCH_LOST, board.transmit("SUPP", "SUHO", "tell;x").status);
    EXPECT_EQ(Status::EPOCH_LOST, board.transmit("//SU", "SUHO", "tell;x").status);
    EXPECT_EQ(Status::OK, board.transmit("////", "SUHO", "tell;x").status) << "a broadcast needs no nonce";
    board.passSending(2000);
    board.reboot();
    EXPECT_EQ(0u, epoch()) << "and no boot begins by itself";
    EXPECT_EQ(Status::EPOCH_LOST, raise(0));
    EXPECT_EQ(Status::OK, raise(1000 * loss));
    EXPECT_EQ(1000u * loss, epoch());
    sendAnew("tell;three");
    board.reboot();
    EXPECT_EQ(1000u * loss + 1, epoch());
    sendAnew("tell;four");
  }
}

TEST_F(LostState, of_epochs_takes_no_recording_though_floors_are_lost_with_them) {
  const Bytes fromPair = sealed(KEY, "SUHO", "SUPP", nonce(5, 4), "tell;pair");
  const Bytes fromGroup = sealed(KEY, "//SU", "SUPO", nonce(5, 4), "tell;group");
  ASSERT_TRUE(takes(fromPair));
  ASSERT_TRUE(takes(fromGroup));
  for (uint16_t at = javinolib::FLOORS_AT; at < javinolib::RELAYING_AT; at++) board.eeprom.corrupt(at, 0x33);
  loseEpochs();
  raise(1000);
  for (int boots = 0; boots < 2; boots++) {
    EXPECT_FALSE(takes(fromPair));
    EXPECT_FALSE(takes(fromGroup));
    board.powerUp();
    board.hello();
    board.request(bytesOf(std::string("R\1", 2)));
    board.pass(1000);
  }
  const std::string keys = textOf(board.request('L').body);
  for (const char *with : {"SUPP", "ROMA", "//SU"}) {
    EXPECT_EQ(4, keys.at(keys.find(with) + 4)) << with << ", which may have lost its floors";
  }
  board.setKey("SUPP", OTHER_KEY);
  EXPECT_TRUE(takes(sealed(OTHER_KEY, "SUHO", "SUPP", nonce(5, 4), "tell;anew")));
}

TEST_F(LostState, of_epochs_alone_keeps_the_floors_that_are_there) {
  const Bytes recorded = sealed(KEY, "SUHO", "SUPP", nonce(5, 4), "tell;pair");
  ASSERT_TRUE(takes(recorded));
  loseEpochs();
  EXPECT_FALSE(takes(recorded));
  EXPECT_TRUE(takes(sealed(KEY, "SUHO", "SUPP", nonce(5, 40), "tell;new")));
  const std::string keys = textOf(board.request('L').body);
  EXPECT_EQ(0, keys.at(keys.find("SUPP") + 4));
  EXPECT_EQ(4, keys.at(keys.find("//SU") + 4)) << "others than those with floors may have spoken";
}

TEST_F(LostState, of_RAM_takes_no_recording_seals_nothing_counts_it_and_tells_its_host) {
  const Bytes recorded = sealed(KEY, "SUHO", "SUPP", nonce(5, 4), "tell;pair");
  ASSERT_TRUE(takes(recorded));
  EXPECT_EQ(0, board.request(bytesOf(std::string("P\0\0\0\0\0\0", 7))).body.at(0));
  memset(static_cast<void *>(board.ram.takenNonces.entries), 0x33, sizeof board.ram.takenNonces.entries);
  EXPECT_FALSE(takes(recorded));
  EXPECT_FALSE(takes(sealed(KEY, "SUHO", "SUPP", nonce(5, 5), "tell;new")));
  EXPECT_EQ(2u, board.counter(Counter::MEMORY_DAMAGED));
  EXPECT_EQ(8, board.request(bytesOf(std::string("P\0\0\0\0\0\0", 7))).body.at(0));
  EXPECT_EQ(Status::MEMORY_DAMAGED, board.transmit("SUPP", "SUHO", "tell;x").status);
  EXPECT_EQ(Status::MEMORY_DAMAGED, raise(1000));
  EXPECT_EQ(Status::OK, board.transmit("////", "SUHO", "tell;x").status);
  board.reboot();
  board.hello();
  board.request(bytesOf(std::string("R\1", 2)));
  EXPECT_FALSE(takes(recorded)) << "the floor";
  EXPECT_EQ(Status::OK, board.transmit("SUPP", "SUHO", "tell;x").status);
}

TEST_F(LostState, of_RAM_is_told_at_hello_where_the_stack_is_over_it_from_the_start) {
  board.ram.isClear = false;
  board.reboot();
  board.hello();
  EXPECT_EQ(2u, board.counter(Counter::MEMORY_DAMAGED)) << "the boot and the hello";
  EXPECT_EQ(Status::MEMORY_DAMAGED, board.transmit("SUPP", "SUHO", "tell;x").status);
}
