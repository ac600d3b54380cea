#pragma once

#include <stdint.h>

#include "../crypto/DerivedKeys.h"
#include "../framing/Frame.h"
#include "../support/Inlining.h"

namespace javinolib {

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

  /// Each step expands the key that it needs, one after the other, as an Uno's stack has no room for both.
  /// @param keys that outlive this object
  explicit Envelope(const DerivedKeys &keys) : keys_(keys) {}

  /// Builds a sealed frame.
  /// @param plain with the content as message, 0…497 bytes
  /// @param nonce 6 bytes that were never used under this key
  /// @param sealed room for the content and 24 bytes
  /// @return the sealed frame's length
  uint16_t seal(const Frame &plain, const uint8_t *nonce, uint8_t *sealed) const {
    return seal(keys_, plain, nonce, sealed);
  }

  /// Whether a sealed frame is long enough and its tag right; nothing of it may be used before.
  /// @param length of the whole frame
  bool isAuthentic(const uint8_t *frame, uint16_t length) const { return isAuthentic(keys_, frame, length); }

  /// Decrypts an authentic frame's content in place.
  /// @return the content's length
  uint16_t open(uint8_t *frame, uint16_t length) const { return open(keys_, frame, length); }

 private:
  static uint16_t seal(const DerivedKeys &keys, const Frame &plain, const uint8_t *nonce, uint8_t *sealed);
  JAVINO_NOINLINE static bool isAuthentic(const DerivedKeys &keys, const uint8_t *frame, uint16_t length);
  static uint16_t open(const DerivedKeys &keys, uint8_t *frame, uint16_t length);
  JAVINO_NOINLINE static void apply(const DerivedKeys &keys, uint8_t *frame, uint16_t length, bool decrypting);

  const DerivedKeys &keys_;
};

}  // namespace javinolib
