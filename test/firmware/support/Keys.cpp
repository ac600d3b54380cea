#include "Keys.h"

bool holds(const javinolib::KeyStore &store, uint8_t slot, const Bytes &key) {
  javinolib::DerivedKeys stored;
  javinolib::DerivedKeys expected;
  expected.derive(key.data());
  return slot != javinolib::KeyStore::NO_SLOT && store.load(slot, stored) && stored.equals(expected);
}
