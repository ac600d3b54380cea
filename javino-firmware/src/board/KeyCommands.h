#pragma once

#include <stdint.h>

#include "../storage/KeyStore.h"
#include "../support/NoInline.h"
#include "Receiver.h"
#include "Reply.h"
#include "Status.h"

namespace javino {

/// The commands that manage keys (SPEC 4.3: K, D, L). None of them gives away more of a key than its check value.
class KeyCommands {
 public:
  KeyCommands(KeyStore &keys, Receiver &receiver) : keys_(keys), receiver_(receiver) {}

  Status set(const uint8_t *body, uint16_t length, Reply &reply);
  Status erase(const uint8_t *body, uint16_t length);
  Status list(uint16_t length, Reply &reply);

 private:
  JAVINO_NOINLINE void addCheckValue(uint8_t slot, Reply &reply) const;

  KeyStore &keys_;
  Receiver &receiver_;
};

}  // namespace javino
