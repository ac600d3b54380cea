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

  /// The place of the nonce in a sealed frame.
  static const uint8_t NONCE_AT = HEADER_LENGTH;

  /// The place of the content in a sealed frame, once opened.
  static const uint8_t CONTENT_AT = NONCE_AT + NONCE_LENGTH;

  /// Each step expands the key that it needs, one after the other, as an Uno's stack has no room for both.
  /// @param keys that outlive this object
  explicit Envelope(const DerivedKeys &keys) : keys_(keys) {}

  /// Seals a frame in place: its header is there, and its content where it is to be.
  /// @param length of the whole frame
  /// @param nonce 6 bytes that were never used under this key
  void seal(uint8_t *frame, Length length, const uint8_t *nonce) const { seal(keys_, frame, length, nonce); }

  /// Whether a sealed frame is long enough and its tag right; nothing of it may be used before.
  /// @param length of the whole frame
  bool isAuthentic(const uint8_t *frame, Length length) const { return isAuthentic(keys_, frame, length); }

  /// Decrypts an authentic frame's content in place.
  /// @return the content's length
  uint16_t open(uint8_t *frame, Length length) const { return open(keys_, frame, length); }

 private:
  static void seal(const DerivedKeys &keys, uint8_t *frame, Length length, const uint8_t *nonce);
  JAVINO_NOINLINE static bool isAuthentic(const DerivedKeys &keys, const uint8_t *frame, Length length);
  static uint16_t open(const DerivedKeys &keys, uint8_t *frame, Length length);
  JAVINO_NOINLINE static void apply(const DerivedKeys &keys, uint8_t *frame, Length length, bool decrypting);

  const DerivedKeys &keys_;
};

}  // namespace javinolib
