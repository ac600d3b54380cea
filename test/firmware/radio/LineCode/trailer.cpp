#include <gtest/gtest.h>

#include <random>
#include <set>

#include "radio/LineCode.h"
#include "support/Vectors.h"

using namespace javinolib;

namespace {

const size_t TRAILER_SYMBOLS = 2 * (1 + 16);

void addSymbol(Bits &bits, uint8_t symbol) {
  for (int i = 0; i < linecode::BITS_PER_SYMBOL; i++) bits.push_back((symbol >> i & 1) != 0);
}

Bits preamble() {
  Bits bits;
  for (uint8_t i = 0; i < linecode::PREAMBLE_SYMBOLS; i++) addSymbol(bits, linecode::preambleSymbol(i));
  return bits;
}

// The fewest bits in which as many of these in a row differ from the last of the preamble.
int distanceToStart(const Bits &bits, int window) {
  const uint64_t mask = (1ull << window) - 1;
  const auto add = [mask](uint64_t last, bool bit) { return (last << 1 | bit) & mask; };
  uint64_t start = 0;
  for (bool bit : preamble()) start = add(start, bit);
  uint64_t last = 0;
  int fewest = window;
  int came = 0;
  for (bool bit : bits) {
    last = add(last, bit);
    if (++came >= window) fewest = std::min(fewest, __builtin_popcountll(last ^ start));
  }
  return fewest;
}

bool holdsStart(const Bits &bits) { return distanceToStart(bits, 12) == 0; }

Bits symbols(std::initializer_list<uint8_t> list) {
  Bits bits;
  for (uint8_t symbol : list) addSymbol(bits, symbol);
  return bits;
}

}  // namespace

TEST(Trailer, hasASymbolOfThreeOnesForEachNibble) {
  std::set<uint8_t> seen;
  for (uint8_t nibble = 0; nibble < 16; nibble++) {
    const uint8_t symbol = linecode::trailerSymbolOf(nibble);
    EXPECT_EQ(__builtin_popcount(symbol), 3);
    EXPECT_EQ(linecode::trailerNibbleOf(symbol), nibble);
    seen.insert(symbol);
  }
  EXPECT_EQ(seen.size(), 16u);
  for (uint8_t symbol = 0; symbol < 64; symbol++) {
    if (seen.count(symbol) != 0) continue;
    EXPECT_EQ(linecode::trailerNibbleOf(symbol), linecode::NO_NIBBLE) << int(symbol);
  }
}

TEST(Trailer, hasTheBitsOfTheVectors) {
  for (const TrailerVector &vector : trailerVectors()) {
    Bits bits = reference::packetBits(vector.payload);
    for (uint8_t byte : vector.trailer) {
      addSymbol(bits, linecode::trailerSymbolOf(byte >> 4));
      addSymbol(bits, linecode::trailerSymbolOf(byte & 0x0F));
    }
    EXPECT_EQ(bits, vector.bits);
  }
}

// A start is two symbols long: three hold it at whatever offset.
TEST(Trailer, neverHoldsTheStartAtAnyOffset) {
  for (uint8_t a = 0; a < 16; a++) {
    for (uint8_t b = 0; b < 16; b++) {
      for (uint8_t c = 0; c < 16; c++) {
        const uint8_t first = linecode::trailerSymbolOf(a);
        const uint8_t second = linecode::trailerSymbolOf(b);
        const uint8_t third = linecode::trailerSymbolOf(c);
        EXPECT_FALSE(holdsStart(symbols({first, second, third})));
        EXPECT_FALSE(holdsStart(symbols({linecode::symbolOf(a), second, third}))) << "behind one symbol of a packet";
        EXPECT_FALSE(holdsStart(symbols({linecode::symbolOf(a), linecode::symbolOf(b), third}))) << "behind two";
      }
      EXPECT_FALSE(holdsStart(symbols({linecode::trailerSymbolOf(a), linecode::trailerSymbolOf(b), 0, 0})))
          << "ahead of silence";
    }
  }
}

// Then follows silence of any length, and the training of the next packet.
TEST(Trailer, doesNotMakeAStartWithWhatFollows) {
  for (uint8_t a = 0; a < 16; a++) {
    for (uint8_t b = 0; b < 16; b++) {
      for (int silence = 0; silence <= 12; silence++) {
        Bits bits = symbols({linecode::trailerSymbolOf(a), linecode::trailerSymbolOf(b)});
        bits.resize(bits.size() + static_cast<size_t>(silence));
        for (int i = 0; i < 3; i++) addSymbol(bits, linecode::preambleSymbol(0));
        EXPECT_FALSE(holdsStart(bits)) << silence;
      }
    }
  }
}

// The same test finds the start in packets, whose alphabet has 16 instead of 07.
TEST(Trailer, differsFromPackets_whichHoldTheStart) {
  EXPECT_TRUE(holdsStart(symbols({0x0D, 0x1C, 0x16})));
  EXPECT_FALSE(holdsStart(symbols({0x0D, 0x1C, linecode::trailerSymbolOf(linecode::nibbleOf(0x16))})));
}

TEST(Trailer, beginsWithBytesThatDifferInEachBit) {
  const auto bitsOf = [](uint8_t byte) {
    return symbols({linecode::trailerSymbolOf(byte >> 4), linecode::trailerSymbolOf(byte & 0x0F)});
  };
  const Bits mark = bitsOf(linecode::TRAILER_MARK);
  const Bits parity = bitsOf(linecode::TRAILER_PARITY);
  for (size_t i = 0; i < 12; i++) EXPECT_NE(mark[i], parity[i]) << i;
  Bits before(12);  // silence, or the next packet
  const Bits next = preamble();
  before.insert(before.end(), next.begin(), next.end());
  for (const Bits &byte : {mark, parity}) {
    for (size_t at = 0; at + 12 <= before.size(); at++) {
      int differences = 0;
      for (size_t i = 0; i < 12; i++) differences += before[at + i] != byte[i];
      EXPECT_GE(differences, 4) << at;
    }
  }
}

// For a receiver that takes the last 36 bits of training and start with up to three wrong ones for a start.
TEST(Trailer, looksLikeADamagedStartLessThanOnceInTwoThousand) {
  std::mt19937 random(15);
  const int trailers = 100000;
  int starts = 0;
  for (int i = 0; i < trailers; i++) {
    Bits bits;
    for (int k = 0; k < 6; k++) addSymbol(bits, linecode::symbolOf(random() % 16));
    for (size_t k = 0; k < TRAILER_SYMBOLS; k++) addSymbol(bits, linecode::trailerSymbolOf(random() % 16));
    bits.resize(bits.size() + 35);
    starts += distanceToStart(bits, 36) <= 3;
  }
  RecordProperty("starts", starts);
  EXPECT_LT(starts, trailers / 2000);
}
