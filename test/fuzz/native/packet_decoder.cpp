// Bytes of a serial line: PacketDecoder judges each packet as SPEC 4.1 does, and Frame::parse reads what write makes.

#include <framing/Frame.h>
#include <framing/PacketEncoder.h>

#include <cstring>
#include <stdexcept>

#include "Input.h"
#include "support/BufferedDecoder.h"
#include "support/Reference.h"

using namespace javinolib;

namespace {

PacketEvent expected(const Bytes &packet) {
  if (packet.empty()) return PacketEvent::NONE;
  Bytes decoded;
  try {
    decoded = reference::cobsDecoded(packet);
  } catch (const std::invalid_argument &) {
    return PacketEvent::BAD_COBS;
  }
  if (decoded.size() > MAX_PACKET_LENGTH) return PacketEvent::TOO_LONG;
  if (decoded.size() < MIN_PACKET_LENGTH) return PacketEvent::TOO_SHORT;
  const uint16_t crc = reference::crc(Bytes(decoded.begin(), decoded.end() - 2));
  const bool right = decoded[decoded.size() - 2] == (crc & 0xFF) && decoded.back() == crc >> 8;
  return right ? PacketEvent::PACKET : PacketEvent::BAD_CRC;
}

void checkHeader(const uint8_t *bytes, uint16_t length) {
  Frame frame;
  if (Frame::parse(bytes, length, frame) != FrameError::NONE) return;
  uint8_t header[HEADER_LENGTH];
  Frame::writeHeader(header, frame.destination, frame.origin, frame.length);
  require(std::memcmp(header, bytes, HEADER_LENGTH) == 0, "a frame that was read is written as it was");
  require(frame.message == bytes + HEADER_LENGTH && frame.length == length - HEADER_LENGTH,
          "its message is all the rest");
}

void checkPacket(const PacketDecoder &decoder) {
  const Bytes frame(decoder.frame(), decoder.frame() + decoder.frameLength());
  checkHeader(frame.data(), decoder.frameLength());
  Bytes inner = Bytes{decoder.sequence()} + frame + Bytes(2, 0);
  PacketEncoder encoder;
  encoder.start(inner.data(), static_cast<uint16_t>(inner.size() - 2));
  BufferedDecoder again;
  PacketEvent event = PacketEvent::NONE;
  while (!encoder.done()) event = again.add(encoder.next());
  require(event == PacketEvent::PACKET && again.sequence() == decoder.sequence(), "what was decoded can be encoded");
  require(Bytes(again.frame(), again.frame() + again.frameLength()) == frame, "and is the same then");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  BufferedDecoder decoder;
  Bytes packet;
  for (size_t i = 0; i < size; i++) {
    const PacketEvent event = decoder.add(data[i]);
    if (data[i] != 0) {
      require(event == PacketEvent::NONE, "nothing ends but at a zero");
      packet.push_back(data[i]);
      continue;
    }
    require(event == expected(packet), "the packet is judged as SPEC 4.1 says");
    if (event == PacketEvent::PACKET) checkPacket(decoder);
    packet.clear();
  }
  checkHeader(data, static_cast<uint16_t>(size));
  return 0;
}
