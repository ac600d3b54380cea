// Bits from the air: after any of them RadioDecoder finds the next packet, and counts each that it hands on.

#include <radio/RadioDecoder.h>

#include "Input.h"
#include "support/ReferencePacket.h"

using namespace javino;

namespace {

const size_t SILENT_BITS = 48;  // with them every packet under way has broken

// A decoder with its queue, as the modem has them.
struct Receiver {
  Receiver() : counters(), decoder(queue, counters) {}

  void add(const Bits &bits) {
    for (bool bit : bits) decoder.add(bit);
  }

  Bytes take() {
    uint8_t payload[MAX_RADIO_PAYLOAD];
    const uint8_t length = queue.take(payload);
    require(length <= MAX_RADIO_PAYLOAD, "a payload has at most 77 bytes");
    taken += length != 0;
    return Bytes(payload, payload + length);
  }

  RadioQueue queue;
  RadioCounters counters;
  RadioDecoder decoder;
  uint32_t taken = 0;
};

Bits rawBits(Input &input) {
  Bits bits;
  for (uint8_t byte : input.bytes(64)) {
    for (int bit = 0; bit < 8; bit++) bits.push_back((byte >> bit & 1) != 0);
  }
  return bits;
}

Bytes payload(Input &input) {
  Bytes bytes = input.bytes(MAX_RADIO_PAYLOAD - 1);
  bytes.push_back(input.byte());
  return bytes;
}

// A packet of which some bits were turned.
Bits damagedBits(Input &input) {
  Bits bits = reference::packetBits(payload(input));
  for (int left = input.byte() % 8; left > 0; left--) {
    const size_t at = input.word() % bits.size();
    bits[at] = !bits[at];
  }
  return bits;
}

void step(Input &input, Receiver &receiver) {
  switch (input.byte() % 6) {
    case 0:
      return receiver.add(rawBits(input));
    case 1:
      return receiver.add(reference::lineBits(input.bytes(90)));
    case 2:
      return receiver.add(reference::packetBits(payload(input)));
    case 3:
      return receiver.add(damagedBits(input));
    case 4:
      return receiver.decoder.abandon();
    default:
      receiver.take();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  Input input(data, size);
  Receiver receiver;
  while (!input.empty()) step(input, receiver);
  while (!receiver.take().empty()) {
  }
  require(receiver.taken == receiver.counters.received, "what is handed on is counted, and nothing else");
  receiver.add(Bits(SILENT_BITS));
  const Bytes last = {1, 2, 3, 4, 5};
  receiver.add(reference::packetBits(last));
  require(receiver.take() == last, "the next packet is found");
  return 0;
}
