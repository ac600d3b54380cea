#pragma once

#include "support/SimulatedAsk.h"

// A modem on simulated hardware.
class Modem {
 public:
  static const int BIT = 1000;  // ticks, at 2000 bit/s

  Modem() { radio.begin(); }

  // The next packet that is whole. What is damaged is mended in steps.
  Bytes take() {
    javinolib::Received with = {0, 0};
    const uint8_t *payload = radio.receive(with);
    for (int steps = 0; payload == nullptr && !radio.idle() && steps < 1000; steps++) payload = radio.receive(with);
    if (payload == nullptr) return Bytes();
    const Bytes taken(payload, payload + with.length);
    radio.release();
    return taken;
  }

  bool send(const Bytes &payload) { return radio.send(payload.data(), static_cast<uint8_t>(payload.size())); }

  // Now: what was heard before is said once.
  bool hearsCarrier() const {
    radio.carrier();
    return radio.carrier();
  }

  javinolib::RadioCounters counters() const {
    javinolib::RadioCounters counters;
    radio.counters(counters);
    return counters;
  }

  SimulatedAsk hardware;
  javinolib::AskRadio radio;
};

// A packet with silence behind it, long enough for the receiver to close it.
inline AirLine packetLine(const Bytes &payload, double bitTicks = Modem::BIT) {
  return AirLine().bits(reference::packetBits(payload), bitTicks).silence(12 * bitTicks);
}

inline Bytes randomPayload(std::mt19937 &random) { return randomBytes(random() % 77 + 1, random); }
