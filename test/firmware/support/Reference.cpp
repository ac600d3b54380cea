#include "Reference.h"

#include <stdexcept>

#include "Digits.h"

namespace reference {

uint16_t crc(const Bytes &bytes) {
  uint16_t remainder = 0xFFFF;
  for (uint8_t byte : bytes) {
    remainder ^= byte;
    for (int bit = 0; bit < 8; bit++) {
      remainder = static_cast<uint16_t>((remainder & 1) != 0 ? remainder >> 1 ^ 0x8408 : remainder >> 1);
    }
  }
  return static_cast<uint16_t>(~remainder);
}

Bytes cobs(const Bytes &bytes) {
  Bytes encoded;
  Bytes block;
  bool blockDue = true;
  for (uint8_t byte : bytes) {
    blockDue = true;
    if (byte != 0) block.push_back(byte);
    if (byte == 0 || block.size() == 254) {
      encoded.push_back(static_cast<uint8_t>(block.size() + 1));
      encoded = encoded + block;
      block.clear();
      blockDue = byte == 0;
    }
  }
  if (blockDue) {
    encoded.push_back(static_cast<uint8_t>(block.size() + 1));
    encoded = encoded + block;
  }
  return encoded;
}

Bytes cobsDecoded(const Bytes &bytes) {
  Bytes decoded;
  for (size_t i = 0; i < bytes.size();) {
    const uint8_t code = bytes[i++];
    if (code == 0 || i + code - 1 > bytes.size()) throw std::invalid_argument("no COBS: " + toHex(bytes));
    decoded.insert(decoded.end(), bytes.begin() + i, bytes.begin() + i + code - 1);
    i += code - 1u;
    if (code != 0xFF && i < bytes.size()) decoded.push_back(0);
  }
  return decoded;
}

Bytes packet(uint8_t sequence, const Bytes &frame) {
  Bytes inner = Bytes{sequence} + frame;
  const uint16_t check = crc(inner);
  return cobs(inner + Bytes{static_cast<uint8_t>(check), static_cast<uint8_t>(check >> 8)}) + Bytes{0};
}

Bytes frame(const std::string &destination, const std::string &origin, const Bytes &message) {
  const size_t bits = message.size() * 8;
  return bytesOf(destination + origin + digits().at(bits / 64) + digits().at(bits % 64)) + message;
}

}  // namespace reference
