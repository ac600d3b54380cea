#pragma once

#include <framing/PacketDecoder.h>

/// A decoder with room for the longest packet.
class BufferedDecoder : public javinolib::PacketDecoder {
 public:
  BufferedDecoder() : PacketDecoder(bytes_, sizeof bytes_) {}

 private:
  uint8_t bytes_[javinolib::MAX_PACKET_LENGTH];
};
