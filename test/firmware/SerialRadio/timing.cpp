#include <ArduinoMock.h>
#include <gtest/gtest.h>
#include <serialradio/SerialRadio.h>

#include "support/FakeClock.h"
#include "support/FakeUart.h"
#include "support/Reference.h"

using testing::NiceMock;
using testing::Return;

namespace {

const uint8_t AUX = 22;
const Bytes HELP = reference::frame("////", "CAFE", bytesOf("tell;help"));

class SerialRadioTiming : public testing::Test {
 protected:
  SerialRadioTiming() {
    aux(HIGH);
    radio.begin();
  }

  void aux(int level) { ON_CALL(arduino, digitalRead(AUX)).WillByDefault(Return(level)); }
  bool send() { return radio.send(HELP.data(), static_cast<uint8_t>(HELP.size())); }

  bool receive() {
    javinolib::Received with;
    return radio.receive(with) != nullptr;
  }

  void pass(uint32_t millis) {
    clock.millis += millis;
    receive();
  }

  NiceMock<ArduinoMock> arduino;
  FakeClock clock;
  FakeUart uart;
  javinolib::SerialRadio radio{uart, JAVINO_HC_12, AUX};
};

}  // namespace

TEST_F(SerialRadioTiming, opens_the_port_at_its_modules_rate) { EXPECT_EQ(9600u, uart.baud); }

TEST_F(SerialRadioTiming, starts_at_a_port_that_never_tells_its_room) {
  struct SilentUart : FakeUart {
    int availableForWrite() override { return 0; }
  } silent;
  EXPECT_TRUE(javinolib::SerialRadio(silent, JAVINO_HC_12).begin());
}

TEST_F(SerialRadioTiming, has_the_times_of_the_specification) {
  javinolib::SerialRadio e32(uart, JAVINO_E32);
  javinolib::SerialRadio e22(uart, JAVINO_E22);
  EXPECT_EQ(35 + 86, radio.airtimeMillis(77));
  EXPECT_EQ(35, radio.slotMillis());
  EXPECT_EQ(65 + 314, e32.airtimeMillis(52));
  EXPECT_EQ(170, e32.slotMillis());
  EXPECT_EQ(65 + 449, e22.airtimeMillis(77));
  EXPECT_EQ(77, e22.longestPayload());
}

TEST_F(SerialRadioTiming, sends_for_the_airtime_and_then_another_packet) {
  ASSERT_TRUE(send());
  EXPECT_FALSE(send());
  pass(static_cast<uint32_t>(radio.airtimeMillis(static_cast<uint8_t>(HELP.size())) - 1));
  EXPECT_TRUE(radio.sending());
  pass(1);
  EXPECT_FALSE(radio.sending());
  javinolib::RadioCounters counters;
  radio.counters(counters);
  EXPECT_EQ(1u, counters.sent);
  pass(65000);  // the clock's low half comes round
  EXPECT_FALSE(radio.sending());
  EXPECT_TRUE(send());
}

TEST_F(SerialRadioTiming, still_sends_while_the_port_takes_no_more) {
  const Bytes longest = reference::frame("////", "CAFE", Bytes(67, 1));
  ASSERT_TRUE(radio.send(longest.data(), 77));
  pass(1000);
  EXPECT_TRUE(radio.sending());
  EXPECT_TRUE(radio.idle());
  uart.take();
  EXPECT_FALSE(radio.idle());
  pass(0);
  EXPECT_FALSE(radio.sending());
}

TEST_F(SerialRadioTiming, hears_a_carrier_from_the_first_byte_to_the_end_of_the_packet) {
  const Bytes packet = reference::packet(0, HELP);
  EXPECT_FALSE(radio.carrier());
  uart.arrive(Bytes(packet.begin(), packet.end() - 1));
  EXPECT_TRUE(radio.carrier());
  pass(39);
  EXPECT_TRUE(radio.carrier());
  uart.arrive({packet.back()});
  EXPECT_TRUE(receive());
  EXPECT_TRUE(radio.carrier()) << "the end came since the last look";
  EXPECT_FALSE(radio.carrier());
}

TEST_F(SerialRadioTiming, a_carrier_without_its_end_is_heard_for_40_ms) {
  uart.arrive({3, 1});
  receive();
  pass(39);
  EXPECT_TRUE(radio.carrier());
  pass(1);
  EXPECT_TRUE(radio.carrier()) << "it was heard at the last look";
  EXPECT_FALSE(radio.carrier());
  pass(65500);
  EXPECT_FALSE(radio.carrier());
}

TEST_F(SerialRadioTiming, hears_the_carrier_while_its_module_is_busy_and_does_not_send_then) {
  aux(LOW);
  EXPECT_TRUE(radio.carrier());
  EXPECT_FALSE(send());
  aux(HIGH);
  radio.carrier();
  EXPECT_FALSE(radio.carrier());
  ASSERT_TRUE(send());
  aux(LOW);
  EXPECT_FALSE(radio.carrier()) << "that is our own packet";
}

TEST_F(SerialRadioTiming, reads_no_pin_if_it_was_given_none) {
  javinolib::SerialRadio plain(uart, JAVINO_HC_12);
  EXPECT_CALL(arduino, pinMode).Times(0);
  EXPECT_CALL(arduino, digitalRead).Times(0);
  EXPECT_TRUE(plain.begin());
  EXPECT_FALSE(plain.carrier());
}
