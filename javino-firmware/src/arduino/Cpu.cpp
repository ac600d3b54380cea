#include "Cpu.h"

#ifdef __AVR__

#include <avr/interrupt.h>
#include <avr/sleep.h>

namespace javinolib {
namespace cpu {

void holdInterrupts() { cli(); }

void releaseInterrupts() { sei(); }

// The instruction behind sei is always performed before any interrupt, so none is lost between the two.
void releaseInterruptsAndIdle() {
  set_sleep_mode(SLEEP_MODE_IDLE);
  sleep_enable();
  sei();
  sleep_cpu();
  sleep_disable();
}

}  // namespace cpu
}  // namespace javinolib

#else

#include "../support/Core.h"

namespace javinolib {
namespace cpu {

// Ports of other cores may take locks, for which interrupts must be on; how to sleep until the next one, yield() knows.
void holdInterrupts() {}

void releaseInterrupts() {}

void releaseInterruptsAndIdle() { yield(); }

}  // namespace cpu
}  // namespace javinolib

#endif
