#pragma once

#include "../Config.h"

namespace javinolib {

/// The parts that a board with a radio has beside sealed unicasts (SPEC 4.3, capabilities): its sketch chooses by the class that it
/// names. The functions that differ are made for each scope, and the linker leaves out those of the other: an `if` on what
/// only the linker knows would come too late, as the compiler has by then chosen what it inlines.
struct WholeScope {
  static const bool MANY = true;    ///< multicasts and broadcasts
  static const bool RENEWS = true;  ///< renewal of keys: an address has two meanwhile
};

/// Sealed unicasts only.
struct UnicastScope {
  static const bool MANY = false;
  static const bool RENEWS = false;
};

static_assert(!UnicastScope::MANY && !UnicastScope::RENEWS, "one capability tells both");

}  // namespace javinolib
