#pragma once

#include <stdint.h>

#include "../Config.h"
#include "../addressing/Address.h"
#include "../framing/Limits.h"
#include "../support/NoInline.h"

namespace javino {

/// Remembers the highest nonce accepted from each origin under each key (SPEC 5.1), in RAM: until the next boot, and
/// until the key is replaced or deleted. It never forgets an origin to make room for another, since a forger who can
/// replay could make it forget.
class ReplayMemory {
 public:
  enum Verdict : uint8_t {
    NEWER,     ///< higher than all accepted so far
    REPLAYED,  ///< not higher
    FULL       ///< from an origin that there is no room to remember
  };

  ReplayMemory();

  /// @param key the place of the key in the key store
  /// @param nonce 6 bytes
  Verdict judge(uint8_t key, const Address &origin, const uint8_t *nonce) const;

  /// Takes over a nonce that was judged NEWER.
  void remember(uint8_t key, const Address &origin, const uint8_t *nonce);

  /// Forgets all that came under a key.
  void forget(uint8_t key);

 private:
  static const uint8_t FREE = 0xFF;
  static const uint8_t NO_ENTRY = 0xFF;

  struct Entry {
    uint8_t key;  // FREE where unused
    Address origin;
    uint8_t nonce[NONCE_LENGTH];
  };

  JAVINO_NOINLINE uint8_t placeFor(uint8_t key, const Address &origin) const;

  Entry entries_[config::REPLAY_ENTRIES];
};

}  // namespace javino
