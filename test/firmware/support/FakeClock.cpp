#include "FakeClock.h"

#include <support/Clock.h>

static FakeClock *currentClock = nullptr;

namespace javinolib {
namespace clock {

uint32_t millis() { return currentClock->millis; }

}  // namespace clock
}  // namespace javinolib

FakeClock::FakeClock() : before_(currentClock) { use(); }

FakeClock::~FakeClock() {
  if (currentClock == this) currentClock = before_;
}

void FakeClock::use() { currentClock = this; }
