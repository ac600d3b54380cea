#pragma once

#include <stdint.h>

#include "../secure/ReplayMemory.h"
#include "../storage/KeyStore.h"
#include "../support/NoInline.h"
#include "Reply.h"
#include "Status.h"

namespace javino {

/// The commands that manage keys (SPEC 4.3: K, N, F, D, L). None of them gives away more of a key than its check value.
/// What the replay memory knows of a key goes after the key itself: else a loss of power between the two would open the
/// door to replays.
class KeyCommands {
 public:
  KeyCommands(KeyStore &keys, ReplayMemory &replays) : keys_(keys), replays_(replays) {}

  /// K: makes a key the only one of its address.
  Status set(const uint8_t *body, uint16_t length, Reply &reply);

  /// N: makes a key the current one of its address. BAD_ARGUMENT where it is the previous one: only K brings that back.
  Status renew(const uint8_t *body, uint16_t length, Reply &reply);

  /// F: deletes the previous key.
  Status finish(const uint8_t *body, uint16_t length);

  /// D: deletes both.
  Status erase(const uint8_t *body, uint16_t length);

  /// L: tells addresses, roles and check values.
  Status list(uint16_t length, Reply &reply);

 private:
  typedef KeyStore::Result (KeyStore::*Change)(const Address &address, const uint8_t *key);

  JAVINO_NOINLINE Status store(Change change, const uint8_t *body, uint16_t length, Reply &reply);
  JAVINO_NOINLINE bool erase(uint8_t slot);
  JAVINO_NOINLINE void addCheckValue(uint8_t slot, Reply &reply) const;

  KeyStore &keys_;
  ReplayMemory &replays_;
};

}  // namespace javino
