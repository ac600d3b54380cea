#include <gtest/gtest.h>

#include "radio/BitClock.h"
#include "support/Modem.h"

using javinolib::BitClock;

namespace {

const uint32_t WHOLE = 60000;  // longer than any level here

// The bits of a line whose levels come in parts: this long at least, and all of the rest where that would be shorter.
Bits bitsOf(const AirLine &line, uint32_t part) {
  BitClock clock(Modem::BIT);
  Bits bits;
  for (const AirLine::Run &run : line.runs()) {
    uint32_t left = static_cast<uint32_t>(run.ticks);
    while (left != 0) {
      uint16_t ticks = static_cast<uint16_t>(left < 2 * part ? left : part);
      left -= ticks;
      bool bit;
      while (clock.advance(ticks, run.level, bit)) bits.push_back(bit);
    }
  }
  return bits;
}

Bits randomBits(size_t count, unsigned seed) {
  std::mt19937 random(seed);
  Bits bits(1, true);  // a line begins with a change
  while (bits.size() < count) bits.push_back(random() & 1);
  return bits;
}

}  // namespace

TEST(BitClock, givesEachBitOnce) {
  const Bits sent = randomBits(2000, 1);
  EXPECT_EQ(bitsOf(AirLine().bits(sent, Modem::BIT), WHOLE), sent);
}

TEST(BitClock, givesTheSameBitsWhenALevelComesInParts) {
  std::mt19937 random(2);
  AirLine line;
  line.bits(randomBits(300, 2), Modem::BIT * 1.01).jitter(150, random).quantise(1);
  const Bits whole = bitsOf(line, WHOLE);
  for (uint32_t part = Modem::BIT / 4; part <= 3 * Modem::BIT; part += 13) {
    EXPECT_EQ(bitsOf(line, part), whole) << "parts of " << part;
  }
}

TEST(BitClock, takesTheLevelOfMoreThanHalfOfABit) {
  // Twelve short pulses in one bit: none lasts long enough to steer.
  const auto bitWithHighTicks = [](double high) {
    AirLine line;
    line.bits({true, false, true, false}, Modem::BIT);
    for (int i = 0; i < 12; i++) line.hold(false, (Modem::BIT - high) / 12).hold(true, high / 12);
    line.hold(false, Modem::BIT);
    return bool(bitsOf(line, WHOLE).at(4));
  };
  EXPECT_FALSE(bitWithHighTicks(480));
  EXPECT_TRUE(bitWithHighTicks(528));
}

TEST(BitClock, survivesAPulseInTheMiddleOfEachBit) {
  const Bits sent = randomBits(500, 3);
  AirLine line;
  for (bool bit : sent) line.hold(bit, 400).hold(!bit, 200).hold(bit, 400);
  EXPECT_EQ(bitsOf(line, WHOLE), sent);
}

TEST(BitClock, worksAtTheShortestAndTheLongestBit) {
  const Bits sent = randomBits(200, 4);
  for (uint16_t bitTicks : {16, 200, 10000, 13107}) {
    BitClock clock(bitTicks);
    Bits received;
    for (bool level : sent) {
      uint16_t ticks = bitTicks;
      bool bit;
      while (clock.advance(ticks, level, bit)) received.push_back(bit);
    }
    EXPECT_EQ(received, sent) << bitTicks;
  }
}
