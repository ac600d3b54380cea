#include <Arduino.h>
#include <ArduinoMock.h>
#include <EepromMock.h>
#include <SerialMock.h>
#include <arduino/Cpu.h>
#include <arduino/JavinoBoard.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <deque>

#include "support/FakeRadio.h"
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

// The class Javino on the mock of the Arduino core: a UART with a buffer of 64 bytes, and an EEPROM in memory.
class JavinoTest : public testing::Test {
 protected:
  JavinoTest() : board(Serial, "test 1.0", radio) {
    cells.fill(0xFF);
    ON_CALL(eeprom, read(_)).WillByDefault(Invoke([this](int at) { return cells.at(at); }));
    ON_CALL(eeprom, write(_, _)).WillByDefault(Invoke([this](int at, uint8_t value) { cells.at(at) = value; }));
    ON_CALL(serial, available()).WillByDefault(Invoke([this] { return static_cast<int>(in.size()); }));
    ON_CALL(serial, read()).WillByDefault(Invoke([this] {
      const uint8_t byte = in.front();
      in.pop_front();
      return byte;
    }));
    ON_CALL(serial, availableForWrite()).WillByDefault(Invoke([this] { return 63 - static_cast<int>(out.size()); }));
    ON_CALL(serial, write(_)).WillByDefault(Invoke([this](uint8_t byte) {
      EXPECT_LT(out.size(), 63u) << "write() would block";
      out.push_back(byte);
      return 1u;
    }));
  }

  void arrive(const Bytes &bytes) { in.insert(in.end(), bytes.begin(), bytes.end()); }

  NiceMock<ArduinoMock> arduino;
  NiceMock<EepromMock> eeprom;
  NiceMock<SerialMock> serial;
  NiceMock<CpuMock> cpu;
  std::array<uint8_t, 4096> cells;
  std::deque<uint8_t> in;
  Bytes out;
  FakeRadio radio;
  javinolib::Javino board;
};

}  // namespace

TEST_F(JavinoTest, opens_the_serial_line_at_the_given_speed) {
  EXPECT_CALL(serial, begin(57600));
  EXPECT_TRUE(board.begin(57600));
}

TEST_F(JavinoTest, says_where_the_radio_cannot_be_started) {
  radio.works = false;
  EXPECT_FALSE(board.begin(115200));
}

TEST_F(JavinoTest, idles_the_cpu_when_there_is_nothing_to_do_having_looked_with_interrupts_held) {
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

TEST_F(JavinoTest, does_not_idle_when_a_byte_came_after_the_work_was_done) {
  board.begin(115200);
  EXPECT_CALL(cpu, holdInterrupts()).WillOnce(Invoke([this] { in.push_back(1); }));
  EXPECT_CALL(cpu, releaseInterrupts());
  EXPECT_CALL(cpu, releaseInterruptsAndIdle()).Times(0);
  board.run();
}

TEST_F(JavinoTest, sends_one_zero_when_it_has_begun) {
  board.begin(115200);
  board.run();
  EXPECT_EQ(Bytes{0}, out);
}

TEST_F(JavinoTest, answers_a_hello_over_Serial) {
  board.begin(115200);
  out.clear();
  arrive(reference::packet(9, reference::frame("++++", "++++", {'H', 1})));
  board.run();
  ASSERT_EQ(0, out.back());
  out.pop_back();
  EXPECT_EQ(9, reference::cobsDecoded(out)[0]);
}

TEST_F(JavinoTest, never_waits_for_the_line_however_long_the_reply_and_idles_meanwhile) {
  board.begin(115200);
  arrive(reference::packet(1, reference::frame("++++", "++++", {'H', 1})));
  board.run();
  out.clear();
  arrive(reference::packet(2, reference::frame("++++", "++++", {'S'})));
  EXPECT_CALL(cpu, releaseInterruptsAndIdle()).Times(testing::AtLeast(1));
  Bytes reply;
  while (reply.empty() || reply.back() != 0) {
    board.run();
    reply = reply + out;
    out.clear();
  }
  EXPECT_GT(reply.size(), 100u);
}
