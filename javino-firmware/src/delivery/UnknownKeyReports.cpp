#include "UnknownKeyReports.h"

#if JAVINO_SESSION_KEYS

namespace javinolib {

void UnknownKeyReports::add(const Frame &frame) {
  for (uint8_t i = 0; i < count(); i++) {
    if (at(i).origin == frame.origin) return;
  }
  if (count() == CAPACITY) return;
  KeylessFrame &kept = append();
  kept.destination = frame.destination;
  kept.origin = frame.origin;
}

}  // namespace javinolib

#endif
