#pragma once

#include <stdint.h>

#include "../Config.h"
#include "../framing/Frame.h"
#include "../support/Inlining.h"
#include "PendingReports.h"

namespace javinolib {

/// A sealed frame for which there was no key.
struct KeylessFrame {
  Address destination;
  Address origin;
};

#if JAVINO_SESSION_KEYS

/// Sealed frames for us for which there was no key, so that the host can agree on one: the first of each origin, and only a
/// few, as anybody can send them in anybody's name (SPEC 4.3).
class UnknownKeyReports : public PendingReports < KeylessFrame, JAVINO_SESSION_KEYS<4 ? 1 : 4> {
 public:
  /// One has come; it is not kept while one of its origin is here, or no more fit.
  JAVINO_NOINLINE void add(const Frame &frame);
};

#else

/// The substitute for it on a board without session keys (Config.h).
class UnknownKeyReports {
 public:
  void add(const Frame &) {}
  bool arePending() const { return false; }
  KeylessFrame next() const { return {}; }
  void tell() {}
  void forgetTold() {}
  void keepTold() {}
};

#endif

}  // namespace javinolib
