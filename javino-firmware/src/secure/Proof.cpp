#include "Proof.h"

#include <string.h>

#include "../framing/Limits.h"

namespace javinolib {

const uint8_t Proof::MAX_BODY_LENGTH;
const uint8_t Proof::LENGTH;
const uint8_t Proof::ASKS_PARITY;

static const uint8_t NONCE_AT = 1;
static const uint8_t SENDER_AT = NONCE_AT + NONCE_LENGTH;
static const uint8_t ACKNOWLEDGER_AT = SENDER_AT + Address::TEXT_LENGTH;
static const uint8_t BODY_AT = ACKNOWLEDGER_AT + Address::TEXT_LENGTH;

void Proof::make(const DerivedKeys &keys, const Claim &claim, uint8_t *proof) {
  uint8_t covered[BODY_AT + MAX_BODY_LENGTH];
  const uint8_t bodyLength = Proof::bodyLength(claim.type);
  covered[0] = static_cast<uint8_t>(claim.asksParity ? claim.type | ASKS_PARITY : claim.type);
  memcpy(covered + NONCE_AT, claim.nonce, NONCE_LENGTH);
  claim.sender.write(covered + SENDER_AT);
  claim.acknowledger.write(covered + ACKNOWLEDGER_AT);
  if (bodyLength != 0) memcpy(covered + BODY_AT, claim.body, bodyLength);
  uint8_t *const tag = covered;  // 16 bytes of the stack less
  keys.authenticate(covered, static_cast<Length>(BODY_AT + bodyLength), tag);
  memcpy(proof, tag, LENGTH);
}

}  // namespace javinolib
