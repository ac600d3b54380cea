#include <gtest/gtest.h>

#include "support/Modem.h"

namespace {

// Every payload that comes out must have been put on the air.
void expectOnlySilenceFrom(Modem &modem) {
  while (!modem.radio.idle()) EXPECT_EQ(modem.take(), Bytes()) << "out of noise";
}

}  // namespace

TEST(AskRadio, makesNothingOfNoiseAndThenReceives) {
  std::mt19937 random(31);
  for (double longestPulse : {3.0, 50.0, 300.0, 1000.0, 3000.0, 20000.0}) {
    Modem modem;
    modem.hardware.delayInterrupts(40);
    for (int i = 0; i < 20; i++) {
      modem.hardware.play(AirLine().noise(1000 * Modem::BIT, longestPulse, random).silence(20 * Modem::BIT));
      expectOnlySilenceFrom(modem);
    }
    modem.hardware.play(packetLine({1, 2, 3}));
    EXPECT_EQ(modem.take(), (Bytes{1, 2, 3})) << "after pulses of up to " << longestPulse << " ticks";
  }
}

TEST(AskRadio, survivesSendingAtAnyMomentOfNoise) {
  std::mt19937 random(32);
  Modem modem;
  for (int i = 0; i < 2000; i++) {
    modem.hardware.play(AirLine().noise((random() % 100) * Modem::BIT, 1500, random));
    if (random() % 5 == 0) modem.send(randomPayload(random));
    if (!modem.radio.sending()) {
      EXPECT_FALSE(modem.hardware.carrier());
    }
    expectOnlySilenceFrom(modem);
  }
  modem.hardware.play(AirLine().silence(1100 * Modem::BIT));
  modem.hardware.play(packetLine({1, 2, 3}));
  EXPECT_EQ(modem.take(), (Bytes{1, 2, 3}));
}

TEST(AskRadio, deliversOnlyWhatWasSentThroughRandomBitErrors) {
  std::mt19937 random(33);
  Modem modem;
  uint32_t delivered = 0;
  const uint32_t sent = 400;
  for (uint32_t i = 0; i < sent; i++) {
    const Bytes payload = randomPayload(random);
    Bits bits = reference::packetBits(payload);
    for (size_t bit = 0; bit < bits.size(); bit++) {
      if (random() % 1000 == 0) bits[bit] = !bits[bit];
    }
    modem.hardware.play(AirLine().bits(bits, Modem::BIT).silence(12 * Modem::BIT));
    const Bytes received = modem.take();
    if (!received.empty()) {
      EXPECT_EQ(received, payload);
      delivered++;
    }
  }
  const javinolib::RadioCounters counters = modem.counters();
  EXPECT_EQ(counters.received, delivered);
  EXPECT_GT(delivered, sent / 3);
  EXPECT_LT(delivered, sent);
  EXPECT_GT(counters.damaged, 0u);
}
