// Any signal on the pin: after it the whole modem finds the next packet, hears no carrier in silence, and has counted
// each packet that it handed on.

#include "Input.h"
#include "support/Modem.h"

namespace {

const uint64_t LONGEST_PACKET = 1100ull * Modem::BIT;  // in ticks

// A modem and what is on the air.
struct Scene {
  Bytes take() {
    const Bytes payload = modem.take();
    require(payload.size() <= javinolib::MAX_RADIO_PAYLOAD, "a payload has at most 77 bytes");
    taken += !payload.empty();
    return payload;
  }

  void hear(const AirLine &line) { modem.hardware.play(line); }

  Modem modem;
  uint32_t taken = 0;
};

double bitTicks(Input &input) { return Modem::BIT * (0.95 + input.byte() / 2560.0); }

AirLine rawBits(Input &input) {
  Bits bits;
  for (uint8_t byte : input.bytes(64)) {
    for (int bit = 0; bit < 8; bit++) bits.push_back((byte >> bit & 1) != 0);
  }
  return AirLine().bits(bits, bitTicks(input));
}

AirLine noise(Input &input) {
  AirLine line;
  bool level = false;
  for (uint8_t byte : input.bytes(100)) line.hold(level = !level, 1 + byte * byte / 4);
  return line;
}

Bytes payload(Input &input) {
  Bytes bytes = input.bytes(javinolib::MAX_RADIO_PAYLOAD - 1);
  bytes.push_back(input.byte());
  return bytes;
}

// A packet of which some bits were turned.
AirLine damaged(Input &input) {
  Bits bits = reference::packetBits(payload(input));
  for (int left = input.byte() % 8; left > 0; left--) {
    const size_t at = input.word() % bits.size();
    bits[at] = !bits[at];
  }
  return AirLine().bits(bits, bitTicks(input));
}

void step(Input &input, Scene &scene) {
  switch (input.byte() % 8) {
    case 0: return scene.hear(rawBits(input));
    case 1: return scene.hear(AirLine().bits(reference::lineBits(input.bytes(90)), bitTicks(input)));
    case 2: return scene.hear(AirLine().bits(reference::packetBits(payload(input)), bitTicks(input)));
    case 3: return scene.hear(damaged(input));
    case 4: return scene.hear(noise(input));
    case 5: scene.modem.send(payload(input)); return;
    case 6: return scene.modem.hardware.wait(input.byte() * 500u);
    default: scene.take();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  if (size > 1000) return 0;
  Input input(data, size);
  Scene scene;
  while (!input.empty()) step(input, scene);
  scene.hear(AirLine().silence(1));
  scene.modem.hardware.wait(2 * LONGEST_PACKET);
  while (!scene.take().empty()) {
  }
  require(!scene.modem.hearsCarrier() && !scene.modem.radio.sending(), "silence is silence");
  const Bytes last = {1, 2, 3, 4, 5};
  scene.hear(packetLine(last));
  require(scene.take() == last, "the next packet is found");
  require(scene.taken == scene.modem.counters().received, "what is handed on is counted, and nothing else");
  return 0;
}
