#include "SessionKeys.h"

#if JAVINO_SESSION_KEYS

#include <string.h>

#include "../support/Wipe.h"

namespace javinolib {

const uint8_t SessionKeys::PLACES;

bool SessionKeys::had(const uint8_t *check) const {
  for (const uint8_t(&known)[DerivedKeys::CHECK_LENGTH] : checks_) {
    if (memcmp(known, check, sizeof known) == 0) return true;
  }
  return false;
}

void SessionKeys::set(uint8_t place, const uint8_t *key, const uint8_t *check) {
  memcpy(keys_[place], key, Aes128::KEY_LENGTH);
  memcpy(checks_[place], check, DerivedKeys::CHECK_LENGTH);
  use(place);
}

void SessionKeys::erase(uint8_t place) {
  wipe(keys_[place], Aes128::KEY_LENGTH);
  memcpy(checks_[PLACES + nextCheck_], checks_[place], DerivedKeys::CHECK_LENGTH);
  nextCheck_ = static_cast<uint8_t>((nextCheck_ + 1) % PLACES);
}

void SessionKeys::use(uint8_t place) {
  for (uint8_t &age : ages_) {
    if (age < ages_[place]) age++;
  }
  ages_[place] = 0;
}

}  // namespace javinolib

#endif
