#pragma once

#include <stdint.h>

#include "../Config.h"
#include "../crypto/DerivedKeys.h"
#include "../support/Inlining.h"
#include "../support/Zeroed.h"

namespace javinolib {

#if JAVINO_SESSION_KEYS

/// The keys of pairs that live in RAM only, at places 0…PLACES - 1 (SPEC 4.3, set session key). They are gone after each boot.
///
/// The shared keys themselves are kept, since what is derived from them would take 19 bytes more of RAM each; to derive it
/// takes some 13 000 cycles, on an Uno 26 000.
class SessionKeys {
 public:
  static const uint8_t PLACES = config::SESSION_KEYS;

  /// To be called once, after a boot.
  void begin() {
    for (uint8_t place = 0; place < PLACES; place++) ages_[place] = place;
  }

  /// Whether a key is, or was one of the last.
  /// @param check its check value, 3 bytes
  JAVINO_NOINLINE bool had(const uint8_t *check) const;

  /// Puts a key into a place that is free.
  void set(uint8_t place, const uint8_t *key, const uint8_t *check);

  /// Overwrites the key at a place; its check value is remembered.
  void erase(uint8_t place);

  /// The key at a place, 16 bytes.
  const uint8_t *keyAt(uint8_t place) const { return keys_[place]; }

  /// Its check value, 3 bytes.
  const uint8_t *checkAt(uint8_t place) const { return checks_[place]; }

  /// The key at a place was set, or a message was sealed or opened with it.
  JAVINO_NOINLINE void use(uint8_t place);

  /// How many of the other places were used later than this one.
  uint8_t ageOf(uint8_t place) const { return ages_[place]; }

 private:
  static const uint8_t CHECKS = 2 * PLACES;

  uint8_t ages_[PLACES];
  uint8_t nextCheck_ JAVINO_ZEROED;
  uint8_t keys_[PLACES][Aes128::KEY_LENGTH] JAVINO_ZEROED;
  uint8_t checks_[CHECKS]
                 [DerivedKeys::CHECK_LENGTH] JAVINO_ZEROED;  // behind those of the places the last that are gone
};

#else

/// The substitute for it on a board without session keys (Config.h).
class SessionKeys {
 public:
  static const uint8_t PLACES = 0;

  void begin() {}
  bool had(const uint8_t *) const { return false; }
  void set(uint8_t, const uint8_t *, const uint8_t *) {}
  void erase(uint8_t) {}
  const uint8_t *keyAt(uint8_t) const { return nullptr; }
  const uint8_t *checkAt(uint8_t) const { return nullptr; }
  void use(uint8_t) {}
  uint8_t ageOf(uint8_t) const { return 0; }
};

#endif

}  // namespace javinolib
