#include <gtest/gtest.h>

#include "support/Modem.h"
#include "support/SampledReceiver.h"

namespace {

// The bits that the transmitter has put on the air so far.
AirLine recorded(const SimulatedAsk &hardware) {
  AirLine line;
  const std::vector<SimulatedAsk::Change> &changes = hardware.carrierChanges();
  for (size_t i = 0; i + 1 < changes.size(); i++) {
    line.hold(changes[i].level, static_cast<double>(changes[i + 1].time - changes[i].time));
  }
  return line.silence(20 * Modem::BIT);
}

Bytes ramp(size_t length) {
  Bytes payload;
  for (size_t i = 0; i < length; i++) payload.push_back(static_cast<uint8_t>(i * 7));
  return payload;
}

}  // namespace

TEST(AskRadio, putsTheBitsOfThePacketOnTheAir) {
  for (size_t length : {1, 2, 40, 77}) {
    Modem modem;
    ASSERT_TRUE(modem.send(ramp(length)));
    modem.hardware.wait(1100 * Modem::BIT);
    const AirLine line = recorded(modem.hardware);
    const Bits bits = reference::packetBits(ramp(length));
    for (size_t i = 0; i < bits.size(); i++) {
      // A packet's first bit is off: the record starts with the second.
      if (i > 0) {
        EXPECT_EQ(line.levelAt((i - 1 + 0.01) * Modem::BIT), bits[i]) << "begin of bit " << i;
      }
      if (i > 0) {
        EXPECT_EQ(line.levelAt((i - 1 + 0.99) * Modem::BIT), bits[i]) << "end of bit " << i;
      }
    }
  }
}

TEST(AskRadio, isOnTheAirForTheBitsOfThePacketAndThenOff) {
  Modem modem;
  ASSERT_TRUE(modem.send(ramp(10)));
  const uint64_t bits = 84 + 12 * 10 - 1;  // the first one is off, and not waited for
  modem.hardware.wait(bits * Modem::BIT + Modem::BIT / 2 - 1);
  EXPECT_TRUE(modem.radio.sending());
  EXPECT_EQ(modem.counters().sent, 0u);
  modem.hardware.wait(1);
  EXPECT_FALSE(modem.radio.sending());
  EXPECT_EQ(modem.counters().sent, 1u);
  EXPECT_FALSE(modem.hardware.carrier());
  EXPECT_TRUE(modem.hardware.quiet());
}

TEST(AskRadio, takesOneInterruptABitToSend) {
  Modem modem;
  modem.send(ramp(10));
  modem.hardware.wait(1100 * Modem::BIT);
  EXPECT_EQ(modem.hardware.interrupts(), 84u + 12 * 10);
}

TEST(AskRadio, refusesASecondPacketWhileOneIsOnTheAir) {
  Modem modem;
  EXPECT_TRUE(modem.send(ramp(5)));
  EXPECT_FALSE(modem.send(ramp(6)));
  modem.hardware.wait(1100 * Modem::BIT);
  EXPECT_TRUE(modem.send(ramp(6)));
  modem.hardware.wait(1100 * Modem::BIT);
  EXPECT_EQ(modem.counters().sent, 2u);
}

TEST(AskRadio, refusesNoPayloadAndTooLongOnes) {
  Modem modem;
  EXPECT_FALSE(modem.send(Bytes()));
  EXPECT_FALSE(modem.send(Bytes(78)));
  EXPECT_FALSE(modem.send(Bytes(255)));
  EXPECT_FALSE(modem.radio.sending());
}

TEST(AskRadio, isUnderstoodByASampledReceiver) {
  for (double skew : {-0.02, -0.01, 0.0, 0.01, 0.02}) {
    Modem modem;
    for (size_t length : {1, 16, 77}) {
      modem.send(ramp(length));
      modem.hardware.wait(1200 * Modem::BIT);
    }
    const std::vector<Bytes> understood = SampledReceiver::receive(recorded(modem.hardware), Modem::BIT * (1 + skew));
    EXPECT_EQ(understood, (std::vector<Bytes>{ramp(1), ramp(16), ramp(77)})) << "skew " << skew;
  }
}
