#include "FakeClock.h"

#include <support/Clock.h>

static FakeClock *current = nullptr;

namespace javinolib {
namespace clock {

uint32_t millis() { return current->millis; }

}  // namespace clock
}  // namespace javinolib

FakeClock::FakeClock() : before_(current) { use(); }

FakeClock::~FakeClock() {
  if (current == this) current = before_;
}

void FakeClock::use() { current = this; }
