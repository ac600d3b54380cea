#include "Envelope.h"

#include <string.h>

#include "../crypto/Cfb128.h"
#include "../crypto/Cmac.h"

namespace javinolib {

const uint8_t Envelope::MIN_FRAME_LENGTH;
const uint8_t Envelope::NONCE_AT;
const uint8_t Envelope::CONTENT_AT;

// The tagged bytes lie in the frame in just the order of SPEC 5: destination, origin, size, N, C.
void Envelope::seal(const DerivedKeys &keys, uint8_t *frame, Length length, const uint8_t *nonce) {
  memcpy(frame + NONCE_AT, nonce, NONCE_LENGTH);
  apply(keys, frame, static_cast<Length>(length - MIN_FRAME_LENGTH), false);
  const Length tagged = static_cast<Length>(length - TAG_LENGTH);
  uint8_t tag[Aes128::BLOCK_LENGTH];
  keys.authenticate(frame, tagged, tag);
  memcpy(frame + tagged, tag, TAG_LENGTH);
}

bool Envelope::isAuthentic(const DerivedKeys &keys, const uint8_t *frame, Length length) {
  if (length < MIN_FRAME_LENGTH) return false;
  const Length tagged = static_cast<Length>(length - TAG_LENGTH);
  uint8_t expected[Aes128::BLOCK_LENGTH];
  keys.authenticate(frame, tagged, expected);
  return equalInConstantTime(expected, frame + tagged, TAG_LENGTH);
}

uint16_t Envelope::open(const DerivedKeys &keys, uint8_t *frame, Length length) {
  const uint16_t content = static_cast<Length>(length - MIN_FRAME_LENGTH);
  apply(keys, frame, content, true);
  return content;
}

// Encrypts or decrypts the content. The initial vector is origin, destination, nonce, two zeroes, encrypted: unpredictable,
// as CFB wants it (NIST SP 800-38A appendix C).
void Envelope::apply(const DerivedKeys &keys, uint8_t *frame, Length length, bool decrypting) {
  const Aes128 cipher(keys.encryption);
  uint8_t iv[Aes128::BLOCK_LENGTH];
  memcpy(iv, frame + Address::TEXT_LENGTH, Address::TEXT_LENGTH);
  memcpy(iv + Address::TEXT_LENGTH, frame, Address::TEXT_LENGTH);
  memcpy(iv + 2 * Address::TEXT_LENGTH, frame + NONCE_AT, NONCE_LENGTH);
  iv[14] = 0;
  iv[15] = 0;
  cipher.encrypt(iv);
  const Cfb128 stream(cipher, iv);
  if (decrypting) {
    stream.decrypt(frame + CONTENT_AT, length);
  } else {
    stream.encrypt(frame + CONTENT_AT, length);
  }
}

}  // namespace javinolib
