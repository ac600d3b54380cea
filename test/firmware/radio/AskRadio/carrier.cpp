#include <gtest/gtest.h>

#include "support/CarrierLog.h"

namespace {

const double TWELFTH_BIT = 11;  // begins so many bits after the packet
const double TO_NOTICE = 5.5;   // bits from the last edge to the alarm, where the end has no edge

Bits inverted(Bits bits, size_t place) {
  bits[place] = !bits[place];
  return bits;
}

AirLine lineOf(const Bits &bits) { return AirLine().bits(bits, Modem::BIT).silence(30 * Modem::BIT); }

// A line's level in the middle of each step.
std::vector<bool> levels(const AirLine &line, double step) {
  std::vector<bool> levels;
  double end = 0;
  for (const AirLine::Run &run : line.runs()) {
    end += run.ticks;
    while ((levels.size() + 0.5) * step < end) levels.push_back(run.level);
  }
  return levels;
}

// The line as all of these together make it, each begun so many bits after the first.
AirLine allOf(const std::vector<std::pair<Bits, double>> &packets) {
  const double step = Modem::BIT / 50;
  std::vector<bool> line;
  for (const auto &packet : packets) {
    const std::vector<bool> one =
        levels(AirLine().hold(false, packet.second * Modem::BIT).bits(packet.first, Modem::BIT), step);
    if (line.size() < one.size()) line.resize(one.size());
    for (size_t i = 0; i < one.size(); i++) line[i] = line[i] || one[i];
  }
  AirLine all;
  for (bool level : line) all.hold(level, step);
  return all;
}

AirLine bothOf(const Bits &first, const Bits &second, double shift) {
  return allOf({{first, 0}, {second, shift}}).silence(30 * Modem::BIT);
}

// Has a modem know a line that is silent while nobody sends.
void hearSilence(Modem &modem) { modem.hardware.play(AirLine().hold(true, Modem::BIT).silence(30 * Modem::BIT)); }

// Twenty pulses of two bits that begin so many bits apart.
AirLine pulses(int apart) {
  AirLine line;
  for (int i = 0; i < 20; i++) line.silence((apart - 2) * Modem::BIT).hold(true, 2 * Modem::BIT);
  return line;
}

}  // namespace

TEST(AskRadio, hearsACarrierFromTheTwelfthBitToTheEndOfThePacket) {
  std::mt19937 random(41);
  for (double skew = -0.03; skew < 0.031; skew += 0.01) {
    for (size_t length : {1, 2, 16, 40, 77}) {
      Modem modem;
      CarrierLog log(modem);
      Bytes payload(length);
      for (uint8_t &byte : payload) byte = static_cast<uint8_t>(random());
      const double bits = (84 + 12 * length) * (1 + skew);
      modem.hardware.play(packetLine(payload, Modem::BIT * (1 + skew)).silence(30 * Modem::BIT));
      ASSERT_EQ(log.spans().size(), 1u) << length << " bytes, skew " << skew;
      EXPECT_NEAR(log.spans()[0].begin, TWELFTH_BIT * (1 + skew), 0.1) << length << " bytes, skew " << skew;
      EXPECT_GT(log.spans()[0].end, bits - 4) << length << " bytes, skew " << skew;
      EXPECT_LT(log.spans()[0].end, bits + TO_NOTICE) << length << " bytes, skew " << skew;
    }
  }
}

TEST(AskRadio, hearsACarrierThroughEachSingleWrongBit) {
  const Bits whole = reference::packetBits({'R', 'O', 'M', 'A', 0, 0xFF, 'x', 'y', 'z'});
  for (size_t wrong = 0; wrong < whole.size(); wrong++) {
    Modem modem;
    CarrierLog log(modem);
    modem.hardware.play(lineOf(inverted(whole, wrong)));
    // A wrong bit lets training begin anew behind it.
    const double from = wrong < 14 ? wrong + TWELFTH_BIT + 3 : TWELFTH_BIT + 1;
    EXPECT_TRUE(log.covers(from, whole.size() - 4)) << "bit " << wrong;
    EXPECT_LT(log.spans().back().end, whole.size() + 11.5) << "bit " << wrong;
  }
}

TEST(AskRadio, hearsACarrierWhoseEdgesAreATenthOfABitOff) {
  std::mt19937 random(42);
  for (double skew : {-0.02, 0.0, 0.02}) {
    for (int i = 0; i < 200; i++) {
      Modem modem;
      CarrierLog log(modem);
      const Bytes payload = randomPayload(random);
      modem.hardware.play(packetLine(payload, Modem::BIT * (1 + skew)).jitter(100, random));
      EXPECT_TRUE(log.covers(24, (84 + 12 * payload.size()) * (1 + skew) - 4)) << "skew " << skew;
    }
  }
}

TEST(AskRadio, hearsACarrierWhosePulsesTheReceiverStretches) {
  for (double stretch : {-300.0, -200.0, 200.0, 300.0}) {
    AirLine line;
    for (int i = 0; i < 17; i++) line.silence(Modem::BIT - stretch).hold(true, Modem::BIT + stretch);
    Modem modem;
    CarrierLog log(modem);
    modem.hardware.play(line);
    EXPECT_TRUE(log.covers(13, 33)) << "pulses " << stretch << " ticks longer";
  }
}

TEST(AskRadio, hearsACarrierThroughACollision) {
  const Bits first = reference::packetBits({'f', 'i', 'r', 's', 't', 1, 2, 3, 4, 5, 6, 7});
  const Bits second = reference::packetBits({'s', 'e', 'c', 'o', 'n', 'd', 9, 8, 7, 6, 5, 4});
  for (int tenths = 0; tenths < 300; tenths += 3) {
    // An odd number of bits apart to the microsecond, they fill each other's gaps, and there is no edge to hear.
    if (tenths % 20 == 10 && tenths < 160) continue;
    const double shift = tenths / 10.0;
    Modem modem;
    CarrierLog log(modem);
    modem.hardware.play(bothOf(first, second, shift));
    EXPECT_TRUE(log.covers(36, first.size() + shift - 5)) << "shift " << shift;
    EXPECT_LT(log.spans().back().end, first.size() + shift + 11) << "shift " << shift;
  }
}

TEST(AskRadio, hearsNoCarrierInNoise) {
  std::mt19937 random(43);
  for (double longestPulse : {0.1, 0.6, 1.0, 1.5, 2.0, 4.0}) {
    Modem modem;
    CarrierLog log(modem);
    modem.hardware.play(AirLine().noise(200000.0 * Modem::BIT, longestPulse * Modem::BIT, random));
    EXPECT_LT(log.share(), 0.005) << "pulses of up to " << longestPulse << " bits";
  }
}

// Seven pulses more than the first edge are thirteen periods.
TEST(AskRadio, hearsACarrierInPulsesUpToEightBitsApartAndNoFurther) {
  for (int apart = 3; apart <= 9; apart++) {
    Modem modem;
    CarrierLog log(modem);
    modem.hardware.play(pulses(apart));
    ASSERT_EQ(apart <= 8, !log.spans().empty()) << apart << " bits";
    if (apart <= 8) {
      EXPECT_NEAR(log.spans()[0].begin, 7 * apart + apart - 2, 0.1) << apart << " bits";
    }
  }
}

// The clock of 16 bits has then come round, so that the edge seems to be three bits behind the last but one.
TEST(AskRadio, hearsNoCarrierInOneEdgeAfterSilence) {
  Modem modem;
  modem.hardware.play(pulses(3));
  EXPECT_TRUE(modem.hearsCarrier());
  modem.hardware.play(AirLine().silence(0x10000 + Modem::BIT));
  EXPECT_FALSE(modem.hearsCarrier());
  modem.hardware.play(AirLine().hold(true, Modem::BIT));
  EXPECT_FALSE(modem.hearsCarrier());
}

TEST(AskRadio, hearsNoCarrierInQuietAirOrWhereTheLineStaysHigh) {
  Modem modem;
  CarrierLog log(modem);
  modem.hardware.play(AirLine().silence(50 * Modem::BIT).hold(true, 500 * Modem::BIT).silence(50 * Modem::BIT));
  EXPECT_TRUE(log.spans().empty());
}

TEST(AskRadio, hearsTheEndOfACarrierThatBreaksOffWithinTenBits) {
  const Bits whole = reference::packetBits(Bytes(77, 'x'));
  for (size_t length : {16, 30, 40, 50, 70, 100, 500, 1000}) {
    Modem modem;
    CarrierLog log(modem);
    modem.hardware.play(lineOf(Bits(whole.begin(), whole.begin() + length)));
    EXPECT_TRUE(log.covers(12, length - 4)) << length;
    EXPECT_LT(log.spans().back().end, length + 11) << length;
  }
}

TEST(AskRadio, hearsACarrierForAsLongAsABrokenPacketHadAnnounced) {
  std::mt19937 random(44);
  const Bits whole = reference::packetBits(Bytes(40, 'x'));
  for (size_t length : {70, 100, 300, 500}) {
    Modem modem;
    CarrierLog log(modem);
    modem.hardware.play(AirLine()
                            .bits(Bits(whole.begin(), whole.begin() + length), Modem::BIT)
                            .noise(1000 * Modem::BIT, Modem::BIT, random));
    EXPECT_TRUE(log.covers(12, whole.size() - 8)) << length;
    EXPECT_FALSE(log.covers(12, whole.size() + 60)) << length;
  }
}

TEST(AskRadio, hearsNoCarrierInItsOwnSending) {
  Modem modem;
  CarrierLog log(modem);
  const Bits bits = reference::packetBits(Bytes(40, 'x'));
  modem.hardware.play(AirLine().bits(Bits(bits.begin(), bits.begin() + 80), Modem::BIT));
  EXPECT_TRUE(modem.hearsCarrier());
  modem.send({1, 2, 3});
  EXPECT_FALSE(modem.hearsCarrier());
  modem.hardware.play(packetLine({1}));
  EXPECT_FALSE(modem.hearsCarrier());
  modem.hardware.wait(200 * Modem::BIT);
  modem.hardware.play(AirLine().bits(Bits(bits.begin(), bits.begin() + 80), Modem::BIT));
  EXPECT_TRUE(modem.hearsCarrier());
}

TEST(AskRadio, remembersACarrierUntilItIsAskedForIt) {
  Modem modem;
  EXPECT_FALSE(modem.radio.carrier());
  modem.hardware.play(packetLine({1}).silence(200 * Modem::BIT));
  EXPECT_TRUE(modem.radio.carrier());
  EXPECT_FALSE(modem.radio.carrier());
}

TEST(AskRadio, saysThatACarrierIsHeardAsOftenAsItIsAsked) {
  Modem modem;
  const Bits bits = reference::packetBits(Bytes(40, 'x'));
  modem.hardware.play(AirLine().bits(Bits(bits.begin(), bits.begin() + 80), Modem::BIT));
  for (int i = 0; i < 3; i++) EXPECT_TRUE(modem.radio.carrier());
}

// Now and then bits in the midst of a packet look like the beginning of one, and hide the rest for a moment.
TEST(AskRadio, hearsTheRestOfACarrierWhoseBeginningItSentOver) {
  std::mt19937 random(45);
  const size_t own = 96;  // bits
  int heard = 0;
  for (double skew : {-0.03, -0.02, 0.0, 0.02, 0.03}) {
    for (int i = 0; i < 100; i++) {
      Modem modem;
      CarrierLog log(modem);
      Bytes payload(77);
      for (uint8_t &byte : payload) byte = static_cast<uint8_t>(random());
      modem.send({9});
      modem.hardware.play(packetLine(payload, Modem::BIT * (1 + skew)).jitter(50, random).silence(30 * Modem::BIT));
      const double bits = (84 + 12 * 77) * (1 + skew);
      if (log.covers(own + 55, bits - 4)) heard++;
      EXPECT_LT(log.spans().back().end, bits + 11) << "skew " << skew;
    }
  }
  EXPECT_GE(heard, 485) << "of 500";
}

TEST(AskRadio, hearsTheRestOfACarrierWhoseBeginningAnotherSentOver) {
  const Bits first = reference::packetBits(Bytes(10, 'f'));
  const Bits second = reference::packetBits(Bytes(77, 's'));
  for (int tenths = 200; tenths < 1000; tenths += 7) {
    Modem modem;
    CarrierLog log(modem);
    modem.hardware.play(bothOf(first, second, tenths / 10.0));
    EXPECT_TRUE(log.covers(36, first.size() - 5)) << "shift " << tenths / 10.0;
    EXPECT_TRUE(log.covers(first.size() + 32, second.size() + tenths / 10.0 - 5)) << "shift " << tenths / 10.0;
  }
}

TEST(AskRadio, hearsACarrierFromItsThirdPulseWhereTheLineWasSilentBefore) {
  Modem modem;
  hearSilence(modem);
  CarrierLog log(modem);
  modem.hardware.play(lineOf(reference::packetBits(Bytes(40, 'x'))));
  ASSERT_EQ(log.spans().size(), 1u);
  EXPECT_NEAR(log.spans()[0].begin, 6, 0.1);
  EXPECT_NEAR(log.spans()[0].end, 84 + 12 * 40, TO_NOTICE);
}

// Three or more that begin at once leave no gaps in their training, and no rhythm behind it.
TEST(AskRadio, hearsACarrierWhereManyFillEachOthersGapsIfTheLineWasSilentBefore) {
  std::mt19937 random(46);
  for (size_t senders = 2; senders <= 6; senders++) {
    for (int i = 0; i < 60; i++) {
      std::vector<std::pair<Bits, double>> packets;
      double last = 0;
      for (size_t sender = 0; sender < senders; sender++) {
        Bytes payload(40);
        for (uint8_t &byte : payload) byte = static_cast<uint8_t>(random());
        packets.push_back({reference::packetBits(payload), sender == 0 ? 0 : random() % 400 / 100.0});
        last = std::max(last, packets.back().second);
      }
      Modem modem;
      hearSilence(modem);
      CarrierLog log(modem);
      modem.hardware.play(allOf(packets).silence(30 * Modem::BIT));
      // A wrong count may end it too soon: three pulses later it is heard again.
      EXPECT_GT(log.share(), 0.93 * (84 + 12 * 40 + last) / (84 + 12 * 40 + last + 30)) << senders << " senders";
      EXPECT_LT(log.spans().front().begin, 10 + last) << senders << " senders";
      EXPECT_LT(log.spans().back().end, 84 + 12 * 40 + last + 11) << senders << " senders";
    }
  }
}

// The edge that ends a short gap waits until the one that began it has been dealt with.
TEST(AskRadio, hearsACollisionOnThoughALateInterruptMakesAPulseShorter) {
  for (int before = 1; before < 30; before++) {
    Modem modem;
    hearSilence(modem);
    CarrierLog log(modem);
    AirLine line;
    double bits = 0;
    for (int i = 0; i < 60; i++) {
      const double high = i == before ? 0.65 : i % 2 ? 3.4 : 1.6;  // without a rhythm
      line.hold(true, high * Modem::BIT).silence(0.6 * Modem::BIT);
      bits += high + 0.6;
    }
    modem.hardware.play(line);
    EXPECT_TRUE(log.covers(TWELFTH_BIT, bits)) << "after " << before << " pulses";
  }
}

TEST(AskRadio, hearsNoCarrierForLongInNoiseThatFollowsSilence) {
  std::mt19937 random(47);
  for (double longestPulse : {0.1, 0.6, 1.0, 1.5, 2.0, 4.0}) {
    Modem modem;
    hearSilence(modem);
    CarrierLog log(modem);
    for (int i = 0; i < 100; i++) {
      modem.hardware.play(
          AirLine().noise(2000 * Modem::BIT, longestPulse * Modem::BIT, random).silence(30 * Modem::BIT));
    }
    EXPECT_LT(log.share(), 0.01) << "pulses of up to " << longestPulse << " bits";
  }
}

TEST(AskRadio, hearsACarrierInALineThatStaysHighAfterSilenceForAsLongAsAPacketMayLast) {
  Modem modem;
  hearSilence(modem);
  CarrierLog log(modem);
  modem.hardware.play(AirLine().silence(20 * Modem::BIT).hold(true, 20000 * Modem::BIT).silence(50 * Modem::BIT));
  ASSERT_EQ(log.spans().size(), 1u);
  EXPECT_NEAR(log.spans()[0].begin, 20 + 5, 0.1);
  EXPECT_NEAR(log.spans()[0].end - log.spans()[0].begin, 12 + 12 * 97, 15);
}
