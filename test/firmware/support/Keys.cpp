#include "Keys.h"

bool holds(const javino::KeyStore &store, uint8_t slot, const Bytes &key) {
  javino::DerivedKeys stored;
  javino::DerivedKeys expected;
  expected.derive(key.data());
  return slot != javino::KeyStore::NO_SLOT && store.load(slot, stored) && stored.equals(expected);
}
