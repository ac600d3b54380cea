#pragma once

#include <stdint.h>

#include "../delivery/Outbox.h"
#include "../framing/Frame.h"
#include "../secure/NonceSource.h"
#include "../storage/KeyStore.h"
#include "../storage/RfId.h"
#include "../support/NoInline.h"
#include "Status.h"

namespace javino {

/// Checks a host's frame to an RF address and puts it into the outbox (SPEC 4.2, 4.4).
class Sender {
 public:
  Sender(Outbox &outbox, const RfId &id, const KeyStore &keys, const NonceSource &nonces)
      : outbox_(outbox), id_(id), keys_(keys), nonces_(nonces) {}

  /// @param frame with the plain content as message
  /// @param number the transmission's number, where OK is returned
  /// @return OK, NO_RF_ID, WRONG_ORIGIN, BAD_DESTINATION, NO_KEY, TOO_LONG, QUEUE_FULL, NONCE_EXHAUSTED or STORE_FAILED
  ///         (the boot epoch could not be stored): the first that applies, in this order
  Status send(const Frame &frame, uint8_t &number);

 private:
  JAVINO_NOINLINE Status checkAddresses(const Frame &frame) const;
  Status sendPlain(const Frame &frame, uint8_t &number);
  Status sendSealed(const Frame &frame, uint8_t &number);

  Outbox &outbox_;
  const RfId &id_;
  const KeyStore &keys_;
  const NonceSource &nonces_;
};

}  // namespace javino
