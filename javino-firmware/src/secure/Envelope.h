#pragma once

#include <stdint.h>

#include "../crypto/Aes128.h"
#include "../crypto/Cmac.h"
#include "../crypto/DerivedKeys.h"
#include "../framing/Frame.h"
#include "../support/NoInline.h"

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

  /// Expands the keys, once for all frames of this object: 368 bytes, wiped at the end of life.
  JAVINO_NOINLINE explicit Envelope(const DerivedKeys &keys)
      : encryption_(keys.encryption), authentication_(keys.authentication), cmac_(authentication_) {}

  /// Builds a sealed frame.
  /// @param plain with the content as message, 0…497 bytes
  /// @param nonce 6 bytes that were never used under this key
  /// @param sealed room for the content and 24 bytes
  /// @return the sealed frame's length
  JAVINO_NOINLINE uint16_t seal(const Frame &plain, const uint8_t *nonce, uint8_t *sealed) const;

  /// Whether a sealed frame is long enough and its tag right; nothing of it may be used before.
  /// @param length of the whole frame
  JAVINO_NOINLINE bool isAuthentic(const uint8_t *frame, uint16_t length) const;

  /// Decrypts an authentic frame's content in place.
  /// @return the content's length
  JAVINO_NOINLINE uint16_t open(uint8_t *frame, uint16_t length) const;

 private:
  JAVINO_NOINLINE void initialVector(const uint8_t *frame, uint8_t *iv) const;

  const Aes128 encryption_;
  const Aes128 authentication_;
  const Cmac cmac_;
};

}  // namespace javino
