#include <gtest/gtest.h>

#include "support/Modem.h"

TEST(AskRadio, mendsAndCountsAPacketWithAWrongBit) {
  const Bytes payload = {'t', 'e', 'l', 'l'};
  const Bits whole = reference::packetBits(payload);
  for (size_t i = 48; i < whole.size(); i++) {
    Bits bits = whole;
    bits[i] = !bits[i];
    Modem modem;
    modem.hardware.play(AirLine().bits(bits, Modem::BIT).silence(12 * Modem::BIT));
    EXPECT_EQ(modem.take(), payload) << "bit " << i;
    EXPECT_EQ(modem.counters().received, 1u);
    EXPECT_EQ(modem.counters().mended, 1u);
    EXPECT_EQ(modem.counters().damaged, 0u);
  }
}

TEST(AskRadio, dropsAndCountsATruncatedPacketAndTakesTheNext) {
  const Bits whole = reference::packetBits({'t', 'e', 'l', 'l'});
  for (size_t length = 48; length < whole.size() - 12; length++) {
    Modem modem;
    modem.hardware.play(
        AirLine().bits(Bits(whole.begin(), whole.begin() + length), Modem::BIT).silence(12 * Modem::BIT));
    EXPECT_EQ(modem.take(), Bytes()) << "cut after bit " << length;
    EXPECT_EQ(modem.counters().damaged, 1u) << "cut after bit " << length;
    modem.hardware.play(packetLine({7}));
    EXPECT_EQ(modem.take(), Bytes{7});
  }
}

TEST(AskRadio, deliversNoneOfTwoPacketsThatCollide) {
  const Bits first = reference::packetBits({'f', 'i', 'r', 's', 't', '.'});
  const Bits second = reference::packetBits({'s', 'e', 'c', 'o', 'n', 'd'});
  for (size_t shift = 1; shift < first.size() / 2; shift += 7) {
    Bits both = first;
    both.resize(first.size() + shift);
    for (size_t i = 0; i < second.size(); i++) both[shift + i] = both[shift + i] || second[i];
    Modem modem;
    modem.hardware.play(AirLine().bits(both, Modem::BIT).silence(12 * Modem::BIT));
    EXPECT_EQ(modem.take(), Bytes()) << "shift " << shift;
  }
}
