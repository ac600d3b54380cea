// Boards with VirtualWire ignore trailers.
#include <gtest/gtest.h>

#include "radio/LineCode.h"
#include "support/Modem.h"
#include "support/SampledReceiver.h"

using namespace javinolib;

namespace {

const int ROUNDS = 100;
const int PACKETS_OF_A_ROUND = 100;

Bytes shortPayload(std::mt19937 &random) { return randomBytes(1 + random() % 24, random); }

Bits trailer(std::mt19937 &random) {
  Bytes bytes = {linecode::TRAILER_PARITY};
  for (int i = 0; i < 16; i++) bytes.push_back(static_cast<uint8_t>(random()));
  if (random() % 8 == 0) bytes = {linecode::TRAILER_MARK};
  Bits bits;
  for (uint8_t byte : bytes) {
    for (uint8_t symbol : {linecode::trailerSymbolOf(byte >> 4), linecode::trailerSymbolOf(byte & 0x0F)}) {
      for (int i = 0; i < linecode::BITS_PER_SYMBOL; i++) bits.push_back((symbol >> i & 1) != 0);
    }
  }
  return bits;
}

// From none to more than a slot, and not whole bits.
double gap(std::mt19937 &random) {
  return random() % (random() % 2 == 0 ? 2 : 24) * Modem::BIT + random() % Modem::BIT;
}

// Senders' clocks are wrong by up to 2 %.
double bitTicks(std::mt19937 &random) { return Modem::BIT * (0.98 + random() % 41 / 1000.0); }

Bits after(Bits bits, const Bits &more) {
  bits.insert(bits.end(), more.begin(), more.end());
  return bits;
}

}  // namespace

TEST(Trailer, isIgnoredByAPlainReceiver_whichHearsEachPacketBehindIt) {
  std::mt19937 random(16);
  for (int round = 0; round < ROUNDS; round++) {
    AirLine line;
    std::vector<Bytes> sent;
    for (int i = 0; i < PACKETS_OF_A_ROUND; i++) {
      sent.push_back(shortPayload(random));
      line.bits(after(reference::packetBits(sent.back()), trailer(random)), bitTicks(random)).silence(gap(random));
      sent.push_back(shortPayload(random));
      line.bits(reference::packetBits(sent.back()), bitTicks(random)).silence(gap(random));
    }
    ASSERT_EQ(SampledReceiver::receive(line, Modem::BIT), sent);
  }
}

// It missed the packet, and looks for a start in the trailer.
TEST(Trailer, isNoStartForAPlainReceiverThatHearsItAlone) {
  std::mt19937 random(17);
  for (int round = 0; round < ROUNDS; round++) {
    AirLine line;
    std::vector<Bytes> sent;
    for (int i = 0; i < PACKETS_OF_A_ROUND; i++) {
      const Bits missed = reference::packetBits(shortPayload(random));
      const Bits end(missed.end() - static_cast<long>(random() % 7), missed.end());
      line.bits(after(end, trailer(random)), bitTicks(random)).silence(gap(random));
      sent.push_back(shortPayload(random));
      line.bits(reference::packetBits(sent.back()), bitTicks(random)).silence(gap(random));
    }
    ASSERT_EQ(SampledReceiver::receive(line, Modem::BIT), sent);
  }
}
