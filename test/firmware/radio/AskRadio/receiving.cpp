#include <gtest/gtest.h>

#include <algorithm>

#include "support/Modem.h"
#include "support/SampledReceiver.h"
#include "support/Vectors.h"

namespace {

const int PACKETS = 60;

}  // namespace

TEST(AskRadio, receivesTheVectors) {
  Modem modem;
  for (const RadioVector &vector : radioVectors()) {
    modem.hardware.play(AirLine().bits(vector.bits, Modem::BIT).silence(12 * Modem::BIT));
    EXPECT_EQ(modem.take(), vector.payload);
  }
}

TEST(AskRadio, receivesFromClocksThatAreThreePercentOff) {
  std::mt19937 random(21);
  for (double skew = -0.03; skew < 0.031; skew += 0.005) {
    Modem modem;
    for (int i = 0; i < PACKETS; i++) {
      const Bytes payload = randomPayload(random);
      modem.hardware.play(packetLine(payload, Modem::BIT * (1 + skew)));
      EXPECT_EQ(modem.take(), payload) << "skew " << skew;
    }
  }
}

TEST(AskRadio, receivesEdgesThatAreATenthOfABitOff) {
  std::mt19937 random(22);
  for (double skew : {-0.02, 0.0, 0.02}) {
    Modem modem;
    for (int i = 0; i < PACKETS; i++) {
      const Bytes payload = randomPayload(random);
      modem.hardware.play(packetLine(payload, Modem::BIT * (1 + skew)).jitter(100, random));
      EXPECT_EQ(modem.take(), payload) << "skew " << skew;
    }
  }
}

// As where each byte from the host wakes the CPU.
TEST(AskRadio, receivesWhereTheLoopLooksTenTimesABit) {
  std::mt19937 random(25);
  for (double skew : {-0.01, 0.01}) {
    Modem modem;
    for (int i = 0; i < PACKETS; i++) {
      const Bytes payload = randomPayload(random);
      const AirLine line = packetLine(payload, Modem::BIT * (1 + skew));
      Bytes taken;
      for (const AirLine::Run &run : line.runs()) {
        for (double left = run.ticks; left > 0; left -= Modem::BIT / 10) {
          modem.hardware.play(AirLine().hold(run.level, std::min(left, Modem::BIT / 10.0)));
          if (taken.empty()) taken = modem.take();
        }
      }
      EXPECT_EQ(taken, payload) << "skew " << skew;
    }
  }
}

TEST(AskRadio, receivesThroughGlitchesWhatASampledReceiverDoesAndMore) {
  std::mt19937 random(23);
  const int packets = 300;
  for (double length : {50.0, 100.0, 150.0}) {
    Modem modem;
    int received = 0, sampled = 0;
    for (int i = 0; i < packets; i++) {
      const Bytes payload = randomPayload(random);
      AirLine line = packetLine(payload).glitches(length, 3 * Modem::BIT, random).silence(12 * Modem::BIT);
      modem.hardware.play(line);
      if (modem.take() == payload) received++;
      if (SampledReceiver::receive(line, Modem::BIT) == std::vector<Bytes>{payload}) sampled++;
    }
    EXPECT_GE(received, sampled) << "glitches of " << length << " ticks, one in three bits";
    if (length <= 100) {
      EXPECT_GE(received, packets * 95 / 100) << "glitches of " << length << " ticks";
    }
  }
}

TEST(AskRadio, receivesWhatASenderWithEightSamplesABitMakes) {
  std::mt19937 random(24);
  Modem modem;
  for (int i = 0; i < PACKETS; i++) {
    const Bytes payload = randomPayload(random);
    modem.hardware.play(packetLine(payload, Modem::BIT * 1.01).quantise(Modem::BIT / 8.0));
    EXPECT_EQ(modem.take(), payload);
  }
}

TEST(AskRadio, receivesWhenOtherInterruptsDelayItsOwn) {
  std::mt19937 random(25);
  Modem modem;
  modem.hardware.delayInterrupts(100);  // 50 µs
  for (int i = 0; i < PACKETS; i++) {
    const Bytes payload = randomPayload(random);
    modem.hardware.play(packetLine(payload));
    EXPECT_EQ(modem.take(), payload);
  }
}

TEST(AskRadio, receivesAfterAnyPauseAlsoOfWholeTimerRounds) {
  for (uint64_t pause : {0ull, 1ull, 1000ull, 65535ull, 65536ull, 65537ull, 131072ull, 10000000ull}) {
    Modem modem;
    modem.hardware.play(packetLine({1, 2, 3}));
    modem.hardware.wait(pause);
    modem.hardware.play(packetLine({4, 5}));
    EXPECT_EQ(modem.take(), (Bytes{1, 2, 3}));
    EXPECT_EQ(modem.take(), (Bytes{4, 5})) << "pause of " << pause << " ticks";
  }
}

TEST(AskRadio, receivesAPacketRightBehindAnother) {
  Modem modem;
  AirLine line;
  for (uint8_t i = 0; i < 2; i++) line.bits(reference::packetBits({i, 9, 9}), Modem::BIT);
  modem.hardware.play(line.silence(12 * Modem::BIT));
  for (uint8_t i = 0; i < 2; i++) EXPECT_EQ(modem.take(), (Bytes{i, 9, 9}));
}

TEST(AskRadio, receivesThePacketsOfNoisyAir) {
  std::mt19937 random(26);
  int received = 0;
  Modem modem;
  for (int i = 0; i < PACKETS; i++) {
    const Bytes payload = randomPayload(random);
    modem.hardware.play(AirLine()
                            .noise(200 * Modem::BIT, Modem::BIT, random)
                            .bits(reference::packetBits(payload), Modem::BIT)
                            .noise(100 * Modem::BIT, Modem::BIT, random));
    if (modem.take() == payload) received++;
  }
  // Noise may hold a start symbol just before the packet, once in some hundred times.
  EXPECT_GE(received, PACKETS - 2);
}

TEST(AskRadio, needsNoLoopToFinishAPacketWhoseEndHasNoEdge) {
  for (int byte = 0; byte < 256; byte++) {
    const Bytes payload(3, static_cast<uint8_t>(byte));
    Modem modem;
    modem.hardware.play(packetLine(payload));
    EXPECT_FALSE(modem.radio.idle());
    EXPECT_EQ(modem.take(), payload);
    EXPECT_TRUE(modem.radio.idle());
  }
}

TEST(AskRadio, hasAPacketABitAfterItsEndWhereTheLoopLooks) {
  std::mt19937 random(27);
  for (double skew : {-0.03, 0.0, 0.03}) {
    Modem modem;
    for (int i = 0; i < PACKETS; i++) {
      const Bytes payload = randomPayload(random);
      Bytes taken;
      for (bool bit : reference::packetBits(payload)) {
        modem.hardware.play(AirLine().bits({bit}, Modem::BIT * (1 + skew)));
        const Bytes early = modem.take();
        if (!early.empty()) taken = early;
      }
      modem.hardware.wait(Modem::BIT);
      EXPECT_EQ(taken.empty() ? modem.take() : taken, payload) << "skew " << skew;
      modem.hardware.wait(12 * Modem::BIT);
    }
  }
}

TEST(AskRadio, takesNoInterruptInQuietAirAndOneAnEdgeOtherwise) {
  Modem modem;
  modem.hardware.wait(10000000);
  EXPECT_EQ(modem.hardware.interrupts(), 0u);
  const AirLine line = packetLine({1, 2, 3});
  modem.hardware.play(line);
  modem.hardware.wait(10000000);
  const uint32_t edges = static_cast<uint32_t>(line.runs().size()) - 1;
  EXPECT_EQ(modem.hardware.interrupts(), edges + 2);  // and two alarms at the end
}

TEST(AskRadio, endsTheAlarmUnderAConstantCarrier) {
  Modem modem;
  modem.hardware.play(AirLine().hold(true, 100 * Modem::BIT));
  EXPECT_TRUE(modem.hardware.quiet());
  modem.hardware.play(packetLine({1}));
  EXPECT_EQ(modem.take(), Bytes{1});
}

TEST(AskRadio, countsAsMissedTheThirdPacketThatNobodyFetched) {
  Modem modem;
  for (uint8_t i = 0; i < 3; i++) modem.hardware.play(packetLine({i}));
  EXPECT_EQ(modem.counters().missed, 1u);
  for (uint8_t i = 0; i < 2; i++) EXPECT_EQ(modem.take(), Bytes{i});
  EXPECT_EQ(modem.counters().received, 2u);
}
