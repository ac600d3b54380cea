#pragma once

#include <stdint.h>

#include "../framing/Address.h"
#include "../crypto/DerivedKeys.h"
#include "../support/Inlining.h"

namespace javinolib {

/// Makes the proofs of acknowledgements under one key (SPEC 7.3).
class Proof {
 public:
  static const uint8_t LENGTH = 8;

  /// The kinds of acknowledgements.
  enum Type : uint8_t {
    DELIVERED = 0x06,  ///< nothing comes before the proof
    FRAGMENTS = 0x07,  ///< one byte comes before it: the fragments that are here
    STALE = 0x08       ///< eight bytes come before it: the floor and the receiver's uptime
  };

  /// Added to the type where the acknowledger asks for parity (SPEC 7.3).
  static const uint8_t ASKS_PARITY = 0x10;

  static const uint8_t MAX_BODY_LENGTH = 8;

  /// How many bytes come before the proof.
  static uint8_t bodyLength(Type type) { return type == STALE ? MAX_BODY_LENGTH : type == FRAGMENTS ? 1 : 0; }

  /// The data that a proof covers.
  struct Claim {
    Type type;
    const uint8_t *nonce;   ///< 6 bytes, of the frame that is answered
    const Address &sender;  ///< of that frame
    const Address &acknowledger;
    const uint8_t *body;  ///< what comes before the proof: bodyLength(type) bytes
    bool asksParity;
  };

  /// @param keys of the frame that is answered; they outlive this object
  explicit Proof(const DerivedKeys &keys) : keys_(keys) {}

  /// @param proof room for 8 bytes
  void make(const Claim &claim, uint8_t *proof) const { make(keys_, claim, proof); }

 private:
  JAVINO_NOINLINE static void make(const DerivedKeys &keys, const Claim &claim, uint8_t *proof);

  const DerivedKeys &keys_;
};

}  // namespace javinolib
