#include <gtest/gtest.h>

#include "support/CommandLetters.h"
#include "support/Reference.h"
#include "support/TestBoard.h"

using javinolib::Status;

TEST(RadioBoard, performs_nothing_but_hello_after_each_boot) {
  TestBoard board;
  for (int boot = 0; boot < 3; boot++) {
    board.reboot();
    for (char command : commandLetters() + "Z") {
      if (command == 'H') continue;
      const BoardReply reply = board.request(command);
      EXPECT_EQ(Status::NOT_GREETED, reply.status) << command;
      EXPECT_TRUE(reply.body.empty());
    }
    EXPECT_EQ(Status::NOT_GREETED, board.request(Bytes()).status);
    EXPECT_EQ(Status::NOT_GREETED, board.transmit("////", "ROMA", "tell;help").status);
    EXPECT_EQ(Status::OK, board.hello().status);
    EXPECT_EQ(Status::OK, board.request('L').status);
  }
}

TEST(RadioBoard, a_repeat_that_crosses_a_reboot_is_not_performed) {
  TestBoard board;
  board.start();
  const Bytes request = reference::packet(77, reference::frame("++++", "++++", bytesOf("IROMA")));
  board.sendRaw(request);
  board.reboot();
  const std::vector<Bytes> replies = board.sendRaw(request);
  ASSERT_EQ(1u, replies.size());
  EXPECT_EQ(static_cast<uint8_t>(Status::NOT_GREETED), reference::cobsDecoded(replies[0])[11]);
}

TEST(RadioBoard, tells_version_id_boot_count_capabilities_and_name) {
  TestBoard board;
  board.reboot();
  EXPECT_EQ(bytesOf("\x01++++") + fromHex("00000203") + bytesOf("test 1.0"), board.hello().body);
  board.request('I', bytesOf("ROMA"));
  board.reboot();
  EXPECT_EQ(bytesOf("\x01ROMA") + fromHex("00000303") + bytesOf("test 1.0"), board.hello().body);
}

TEST(RadioBoard, is_not_greeted_by_a_host_of_another_version) {
  TestBoard board;
  for (uint8_t version : {0, 2, 255}) {
    const BoardReply reply = board.request('H', {version});
    EXPECT_EQ(Status::OK, reply.status);
    EXPECT_EQ(1, reply.body.at(0));
    EXPECT_EQ(Status::NOT_GREETED, board.request('L').status);
  }
}

TEST(RadioBoard, tells_the_names_of_its_actions_from_any_offset_on) {
  TestBoard board;
  board.start();
  EXPECT_EQ(Bytes(1, 0), board.request('C', fromHex("0000")).body);
  board.board->actions().add(F("lampOn"), [](const javinolib::Arguments &) { return true; });
  board.board->actions().add(F("go"), [](const javinolib::Arguments &) { return true; });
  const Bytes names = bytesOf(std::string("lampOn\0go\0", 10));
  for (uint8_t offset = 0; offset <= names.size() + 1; offset++) {
    const Bytes rest(names.begin() + std::min<size_t>(offset, names.size()), names.end());
    EXPECT_EQ(Bytes(1, 2) + rest, board.request('C', {0, offset}).body) << int(offset);
  }
  EXPECT_EQ(Bytes(1, 2), board.request('C', fromHex("0100")).body);
  EXPECT_EQ(Bytes(1, 2), board.request('C', fromHex("ffff")).body);
}

TEST(RadioBoard, tells_names_that_fit_no_reply_in_parts) {
  TestBoard board;
  board.start();
  const std::string longName(javinolib::MAX_MESSAGE_LENGTH + 40, 'n');
  std::vector<std::string> names = {"first", longName, "last"};
  Bytes all;
  for (const std::string &name : names) {
    EXPECT_TRUE(board.board->actions().add(F(name.c_str()), [](const javinolib::Arguments &) { return true; }));
    all = all + bytesOf(name) + Bytes(1, 0);
  }
  Bytes told;
  for (int part = 0; part < 2; part++) {
    const uint16_t offset = static_cast<uint16_t>(told.size());
    const BoardReply reply = board.request('C', {static_cast<uint8_t>(offset >> 8), static_cast<uint8_t>(offset)});
    EXPECT_EQ(3, reply.body.at(0));
    EXPECT_LE(reply.body.size(), javinolib::MAX_MESSAGE_LENGTH - 1u);
    told = told + Bytes(reply.body.begin() + 1, reply.body.end());
  }
  EXPECT_EQ(all, told);
}

TEST(RadioBoard, performs_hello_anew_even_where_it_is_byte_by_byte_the_last_one) {
  TestBoard board;
  const Bytes hello = reference::packet(1, reference::frame("++++", "++++", {'H', 1}));
  board.sendRaw(hello);
  board.sendRaw(hello);
  EXPECT_EQ(0u, board.counter(javinolib::Counter::SERIAL_REPEATS));
}

TEST(RadioBoard, begins_although_the_radio_does_not_and_says_so) {
  SimulatedEeprom eeprom;
  SimulatedRam ram;
  FakeClock clock;
  FakePort port;
  FakeRadio radio;
  radio.works = false;
  javinolib::RadioBoard board(javinolib::SerialPort(port), "x", radio);
  EXPECT_FALSE(board.begin());
}
