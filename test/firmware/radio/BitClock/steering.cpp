#include <gtest/gtest.h>

#include "radio/BitClock.h"
#include "support/Modem.h"

using javinolib::BitClock;

namespace {

Bits bitsOf(const AirLine &line, double startedOff) {
  BitClock clock(Modem::BIT);
  Bits bits;
  bool bit;
  uint16_t ticks = static_cast<uint16_t>(startedOff);
  while (clock.advance(ticks, false, bit)) bits.push_back(bit);
  for (const AirLine::Run &run : line.runs()) {
    ticks = static_cast<uint16_t>(run.ticks);
    while (clock.advance(ticks, run.level, bit)) bits.push_back(bit);
  }
  return bits;
}

// Whether one stream ends with the other.
bool endsWith(const Bits &bits, const Bits &end) {
  return bits.size() >= end.size() && std::equal(end.begin(), end.end(), bits.end() - end.size());
}

}  // namespace

TEST(BitClock, locksWithinTheTrainingWhereverItsWindowsBegan) {
  const Bits packet = reference::packetBits({0x12, 0x34, 0x56, 0x78});
  const Bits afterTraining(packet.begin() + 30, packet.end());
  for (double offset = 0; offset < Modem::BIT; offset += 10) {
    EXPECT_TRUE(endsWith(bitsOf(AirLine().bits(packet, Modem::BIT).silence(Modem::BIT / 2), offset), afterTraining))
        << "windows begin " << offset << " ticks before the packet";
  }
}

TEST(BitClock, followsAClockThatIsThreePercentOffThroughTheSparsestSymbols) {
  const Bits packet = reference::packetBits(Bytes(77, 0x88));  // symbol 0x23: changes every third bit
  for (double skew : {-0.03, 0.03}) {
    const Bits received = bitsOf(AirLine().bits(packet, Modem::BIT * (1 + skew)).silence(Modem::BIT / 2), 0);
    EXPECT_TRUE(std::equal(packet.begin(), packet.end(), received.begin())) << "skew " << skew;
  }
}

TEST(BitClock, isNotSteeredByGlitches) {
  // Pulses of a tenth of a bit, always at the place where steering would hurt most, on a line without changes.
  const AirLine line = AirLine().hold(false, 450).hold(true, 100).hold(false, 450);
  BitClock clock(Modem::BIT);
  bool bit;
  unsigned bits = 0;
  for (int i = 0; i < 100; i++) {
    for (const AirLine::Run &run : line.runs()) {
      uint16_t ticks = static_cast<uint16_t>(run.ticks);
      while (clock.advance(ticks, run.level, bit)) bits++;
    }
  }
  EXPECT_EQ(bits, 100u);
}
