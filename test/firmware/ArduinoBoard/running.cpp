#include <Arduino.h>
#include <ArduinoMock.h>
#include <EepromMock.h>
#include <JavinoBDI.h>
#include <arduino/Cpu.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "support/FakeRadio.h"
#include "support/MockedLine.h"
#include "support/Reference.h"

using testing::_;
using testing::Assign;
using testing::Invoke;
using testing::NiceMock;

namespace {

class CpuMock {
 public:
  CpuMock() { current = this; }
  ~CpuMock() { current = nullptr; }

  MOCK_METHOD(void, holdInterrupts, ());
  MOCK_METHOD(void, releaseInterrupts, ());
  MOCK_METHOD(void, releaseInterruptsAndIdle, ());

  static CpuMock *current;
};

CpuMock *CpuMock::current = nullptr;

}  // namespace

namespace javinolib {
namespace cpu {

void holdInterrupts() { CpuMock::current->holdInterrupts(); }
void releaseInterrupts() { CpuMock::current->releaseInterrupts(); }
void releaseInterruptsAndIdle() { CpuMock::current->releaseInterruptsAndIdle(); }

}  // namespace cpu
}  // namespace javinolib

namespace {

// A board on the mock of the Arduino core.
class ArduinoBoard : public testing::Test {
 protected:
  ArduinoBoard() : board(Serial, "test 1.0", radio) {
    cells.fill(0xFF);
    ON_CALL(eeprom, read(_)).WillByDefault(Invoke([this](int at) { return cells.at(at); }));
    ON_CALL(eeprom, write(_, _)).WillByDefault(Invoke([this](int at, uint8_t value) { cells.at(at) = value; }));
  }

  NiceMock<ArduinoMock> arduino;
  NiceMock<EepromMock> eeprom;
  NiceMock<CpuMock> cpu;
  std::array<uint8_t, 4096> cells;
  MockedLine line;
  SerialMock &serial = line.serial;
  Bytes &out = line.out;
  FakeRadio radio;
  JavinoRadioBoard board;
};

}  // namespace

TEST_F(ArduinoBoard, opens_the_serial_line_at_the_given_speed) {
  EXPECT_CALL(serial, begin(57600));
  EXPECT_TRUE(board.begin(57600));
}

TEST_F(ArduinoBoard, says_where_the_radio_cannot_be_started) {
  radio.works = false;
  EXPECT_FALSE(board.begin(115200));
}

TEST_F(ArduinoBoard, idles_the_cpu_when_there_is_nothing_to_do_having_looked_with_interrupts_held) {
  board.begin(115200);
  bool held = false;
  bool lookedMeanwhile = false;
  EXPECT_CALL(cpu, holdInterrupts()).WillOnce(Assign(&held, true));
  ON_CALL(serial, available()).WillByDefault(Invoke([&] {
    lookedMeanwhile = held;
    return 0;
  }));
  EXPECT_CALL(cpu, releaseInterruptsAndIdle());
  EXPECT_CALL(cpu, releaseInterrupts()).Times(0);
  board.run();
  EXPECT_TRUE(lookedMeanwhile);
}

TEST_F(ArduinoBoard, does_not_idle_when_a_byte_came_after_the_work_was_done) {
  board.begin(115200);
  EXPECT_CALL(cpu, holdInterrupts()).WillOnce(Invoke([this] { line.arrive({1}); }));
  EXPECT_CALL(cpu, releaseInterrupts());
  EXPECT_CALL(cpu, releaseInterruptsAndIdle()).Times(0);
  board.run();
}

TEST_F(ArduinoBoard, asks_the_host_to_ask_again_when_it_has_begun) {
  board.begin(115200);
  board.run();
  EXPECT_EQ((Bytes{0, 1, 0}), out);
}

TEST_F(ArduinoBoard, answers_a_hello_over_Serial) {
  board.begin(115200);
  out.clear();
  line.arrive(reference::packet(9, reference::frame("++++", "++++", {'H', 1})));
  board.run();
  ASSERT_LT(2u, out.size());
  EXPECT_EQ((Bytes{0, 0}), Bytes(out.begin(), out.begin() + 2));
  EXPECT_EQ(0, out.back());
  EXPECT_EQ(9, reference::cobsDecoded(Bytes(out.begin() + 2, out.end() - 1))[0]);
}

TEST_F(ArduinoBoard, never_waits_for_the_line_however_long_the_reply_and_idles_meanwhile) {
  board.begin(115200);
  line.arrive(reference::packet(1, reference::frame("++++", "++++", {'H', 1})));
  board.run();
  out.clear();
  line.arrive(reference::packet(2, reference::frame("++++", "++++", {'S'})));
  EXPECT_CALL(cpu, releaseInterruptsAndIdle()).Times(testing::AtLeast(1));
  Bytes reply;
  while (reply.size() < 2 || reply.back() != 0) {
    board.run();
    reply = reply + out;
    out.clear();
  }
  EXPECT_GT(reply.size(), 100u);
}

TEST_F(ArduinoBoard, finds_no_damage_in_the_memory_that_its_first_start_has_cleared) {
  board.begin(115200);
  line.arrive(reference::packet(1, reference::frame("++++", "++++", {'H', 1})));
  board.run();
  out.clear();
  line.arrive(reference::packet(2, reference::frame("++++", "++++", {'S'})));
  Bytes reply;
  while (reply.size() < 3 || reply.back() != 0) {
    board.run();
    reply = reply + out;
    out.clear();
  }
  const Bytes packet = reference::cobsDecoded(Bytes(reply.begin() + 2, reply.end() - 1));
  const size_t crc = packet.size() - 2;  // behind records of five bytes: counter and value
  uint32_t damaged = UINT32_MAX;
  for (size_t at = crc - 5; at > 10; at -= 5) {
    if (packet[at] != static_cast<uint8_t>(javinolib::Counter::MEMORY_DAMAGED)) continue;
    damaged = packet[at + 3] << 8 | packet[at + 4];
    break;
  }
  EXPECT_EQ(0u, damaged);
}

TEST_F(ArduinoBoard, writes_to_a_port_that_never_tells_its_room) {
  ON_CALL(serial, availableForWrite()).WillByDefault(testing::Return(0));
  board.begin(115200);
  board.run();
  EXPECT_EQ((Bytes{0, 1, 0}), out);
}

TEST_F(ArduinoBoard, waits_for_a_port_that_has_told_its_room) {
  EXPECT_CALL(serial, availableForWrite()).WillOnce(testing::Return(1)).WillRepeatedly(testing::Return(0));
  board.begin(115200);
  board.run();
  EXPECT_EQ((Bytes{0}), out);
}
