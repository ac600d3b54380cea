#include "FakeRadio.h"

#include <radio/RadioEncoder.h>

#include <stdexcept>

bool FakeRadio::send(const uint8_t *payload, uint8_t length) {
  if (length == 0 || length > javinolib::MAX_RADIO_PAYLOAD) throw std::logic_error("no radio packet has this length");
  if (onAir_ || refuses) return false;
  sent.push_back(Bytes(payload, payload + length));
  trailers.push_back(trailer_);
  behind.push_back(path_);
  onAir_ = true;
  return true;
}

uint8_t *FakeRadio::receive(javinolib::Received &with) {
  if (working) working();
  if (mends && mender_.lost()) release();
  if (in_.empty()) return nullptr;
  Arrived &first = in_.front();
  if (!mends) {
    with.path = 0;
    with.length = static_cast<uint8_t>(first.payload.size());
    return first.payload.data();
  }
  mender_.setLastTrailer(first.trailer);
  javinolib::Mender::Progress progress;
  do {
    progress = mender_.step(first.packet);
  } while (progress == javinolib::Mender::PENDING);
  if (progress != javinolib::Mender::WHOLE) return nullptr;
  with.path = mender_.path();
  with.length = first.packet.payloadLength();
  return first.packet.payload();
}

void FakeRadio::release() {
  in_.pop_front();
  mender_.begin();
}

javinolib::RadioPacket FakeRadio::packetOf(const Bytes &payload, const std::set<size_t> &wrongBits,
                                           javinolib::Trailer trailer, uint8_t hops) {
  javinolib::RadioPacket packet = javinolib::RadioPacket();
  javinolib::RadioPacket sent;
  javinolib::RadioEncoder encoder;
  encoder.start(payload.data(), static_cast<uint8_t>(payload.size()), trailer, sent.room, hops);
  for (int i = 0; i < javinolib::linecode::PREAMBLE_SYMBOLS * javinolib::linecode::BITS_PER_SYMBOL; i++) encoder.next();
  size_t bits = 0;
  for (; encoder.hasNext(); bits++) {
    if (encoder.next() != (wrongBits.count(bits) != 0))
      packet.room[bits / 8] = static_cast<uint8_t>(packet.room[bits / 8] | 1 << bits % 8);
  }
  packet.symbols = static_cast<uint8_t>(bits / javinolib::linecode::BITS_PER_SYMBOL);
  return packet;
}

void FakeRadio::finishSending() {
  onAir_ = false;
  counts.sent++;
}
