#pragma once

#include <stdint.h>

#include "../delivery/Delivery.h"
#include "../secure/NonceSource.h"
#include "../secure/ReplayMemory.h"
#include "../storage/KeyStore.h"
#include "../support/Inlining.h"
#include "../board/Reply.h"
#include "../support/Status.h"
#include "../support/Part.h"

namespace javinolib {

/// The commands that manage keys (SPEC 4.3: E, K, N, U, F, D, V, L). None of them gives away more of a key than its check value.
/// What the replay memory knows of a key goes after the key itself: else a loss of power between the two would open the
/// door to replays.
class KeyCommands {
 public:
  KeyCommands(KeyStore &keys, ReplayMemory &replays, NonceSource &nonces)
      : keys_(keys), replays_(replays), nonces_(nonces) {}

  /// The boot epoch.
  Uint24 epoch() const { return nonces_->epoch(); }

  /// E: raises the boot epoch.
  Status raiseEpoch(const uint8_t *body, Length length);

  /// K: makes a key the only one of its address; N, which renews: the next one.
  template <typename Scope = WholeScope>
  Status store(bool renews, const uint8_t *body, Length length, Reply &reply);

  enum Change : char {
    USE = 'U',     ///< the next key of an address becomes the current one
    FINISH = 'F',  ///< the previous key goes
    DELETE = 'D'   ///< all keys of the address go
  };

  /// @return BUSY to USE while a message is under way that is sealed with the key to be replaced: when a board has taken a
  ///         key into use, nothing of what it sends is sealed with the one before
  template <typename Scope = WholeScope>
  Status change(Change change, const uint8_t *body, Length length, const Delivery &delivery);

  /// V: sets the session key of a device. What is under way or waits under one that makes room is as with a deleted key.
  template <typename Scope = WholeScope>
  JAVINO_NOINLINE Status setSession(const uint8_t *body, Length length, Delivery &delivery, Reply &reply);

  /// L: tells addresses, roles and check values.
  template <typename Scope = WholeScope>
  Status list(Length length, Reply &reply);

 private:
  bool isOneMorePair(bool renews, const Address &address) const;
  uint8_t placeForSession(const Outbox &outbox) const;
  JAVINO_NOINLINE bool erase(uint8_t slot);
  void addCheckValue(uint8_t slot, Reply &reply) const;

  Part<KeyStore> keys_;
  Part<ReplayMemory> replays_;
  Part<NonceSource> nonces_;
};

}  // namespace javinolib
