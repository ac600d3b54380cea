#pragma once

#include <stdint.h>

#include "../addressing/Address.h"
#include "../crypto/DerivedKeys.h"
#include "../framing/Limits.h"

namespace javino {

/// The secure envelope of unicast and multicast frames (SPEC 5): encrypted, then authenticated. Works on whole frames
/// as they are on the air, `header(10) N(6) C(n) T(8)`.
class Envelope {
 public:
  /// The fewest bytes of a sealed frame: it holds an empty content.
  static const uint8_t MIN_FRAME_LENGTH = HEADER_LENGTH + SEAL_LENGTH;

  /// Where the nonce begins in a sealed frame.
  static const uint8_t NONCE_AT = HEADER_LENGTH;

  /// Where the content begins in a sealed frame, once opened.
  static const uint8_t CONTENT_AT = NONCE_AT + NONCE_LENGTH;

  /// @param keys outlive this object
  explicit Envelope(const DerivedKeys &keys) : keys_(keys) {}

  /// Builds a sealed frame.
  /// @param nonce 6 bytes that were never used under this key
  /// @param length of the content, 0…497 bytes
  /// @param frame room for length + 24 bytes; the content may lie within it
  /// @return the frame's length
  uint16_t seal(Address destination, Address origin, const uint8_t *nonce, const uint8_t *content, uint16_t length,
                uint8_t *frame) const;

  /// Whether a sealed frame is long enough and its tag right; nothing of it may be used before.
  /// @param length of the whole frame
  bool isAuthentic(const uint8_t *frame, uint16_t length) const;

  /// Decrypts an authentic frame's content in place.
  /// @return the content's length
  uint16_t open(uint8_t *frame, uint16_t length) const;

 private:
  void initialVector(const uint8_t *frame, const Aes128 &cipher, uint8_t *iv) const;
  void tag(const uint8_t *frame, uint16_t length, uint8_t *into) const;

  const DerivedKeys &keys_;
};

}  // namespace javino
