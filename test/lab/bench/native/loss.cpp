// Packets that the modem and a sampled receiver lose of the same damaged lines, a JSON object a condition.
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>

#include "support/Modem.h"
#include "support/SampledReceiver.h"

namespace {

const int PACKETS = 1000;
const int BIT = Modem::BIT;

typedef std::function<AirLine(const Bytes &payload, std::mt19937 &random)> Air;

AirLine packet(const Bytes &payload, double skew = 0) { return packetLine(payload, BIT * (1 + skew)); }

void compare(const std::string &condition, const Air &air) {
  std::mt19937 random(1);
  Modem modem;
  int ours = 0, sampled = 0;
  for (int i = 0; i < PACKETS; i++) {
    Bytes payload(40);
    for (uint8_t &byte : payload) byte = static_cast<uint8_t>(random());
    const AirLine line = air(payload, random);
    modem.hardware.play(line);
    for (Bytes got = modem.take(); !got.empty(); got = modem.take()) ours += got == payload;
    for (const Bytes &got : SampledReceiver::receive(line, BIT)) sampled += got == payload;
  }
  printf("{\"condition\":\"%s\",\"packets\":%d,\"oursLost\":%d,\"sampledLost\":%d}\n", condition.c_str(), PACKETS,
         PACKETS - ours, PACKETS - sampled);
}

void skewed(double percent) {
  compare("clock " + std::to_string(static_cast<int>(percent)) + " % off",
          [=](const Bytes &payload, std::mt19937 &) { return packet(payload, percent / 100); });
}

// Pulses of the other level, a mean distance of three bits apart.
void glitched(int percentOfBit) {
  compare("pulses of " + std::to_string(percentOfBit) + " % of a bit, one in 3 bits",
          [=](const Bytes &payload, std::mt19937 &random) {
            return packet(payload).glitches(percentOfBit / 100.0 * BIT, 3 * BIT, random).silence(12 * BIT);
          });
}

void jittered(int percentOfBit, double skew) {
  compare("edges off by up to " + std::to_string(percentOfBit) + " % of a bit" +
              (skew == 0 ? "" : ", clock " + std::to_string(static_cast<int>(skew * 100)) + " % off"),
          [=](const Bytes &payload, std::mt19937 &random) {
            return packet(payload, skew).jitter(percentOfBit / 100.0 * BIT, random);
          });
}

// Noise as a receiver without a carrier gives it, before and behind the packet.
void surroundedByNoise() {
  compare("noise before and behind", [](const Bytes &payload, std::mt19937 &random) {
    return AirLine()
        .noise(200 * BIT, BIT, random)
        .bits(reference::packetBits(payload), BIT)
        .noise(100 * BIT, BIT, random)
        .silence(12 * BIT);
  });
}

void flipped(const char *rate) {
  compare(std::string("bit error rate ") + rate, [=](const Bytes &payload, std::mt19937 &random) {
    std::bernoulli_distribution wrong(atof(rate));
    Bits bits = reference::packetBits(payload);
    for (size_t i = 0; i < bits.size(); i++) bits[i] = bits[i] != wrong(random);
    return AirLine().bits(bits, BIT).silence(12 * BIT);
  });
}

}  // namespace

int main() {
  for (double percent : {-5, -4, -3, 0, 3, 4, 5}) skewed(percent);
  for (int length : {5, 10, 15, 20, 25}) glitched(length);
  for (int length : {10, 20, 25, 30}) jittered(length, 0);
  for (int length : {10, 20}) jittered(length, 0.03);
  surroundedByNoise();
  for (const char *rate : {"0.0001", "0.001", "0.003", "0.01"}) flipped(rate);
}
