#pragma once

#include <stdint.h>

#include "../Config.h"

// AskHardwareAvr.cpp needs the pin-change interrupts of an ATmega.
#ifdef PCICR
#define JAVINO_HAS_ASK_HARDWARE
#endif

namespace javinolib {

class AskRadio;

/// The modem's hardware: a free-running 16-bit timer with one alarm, an output and an input pin.
///
/// The one place where the radio meets the hardware. It is bound when linking, AskHardwareAvr.cpp on a board and a
/// simulated one in the host tests, since a virtual call in each interrupt would cost more cycles than most of these
/// functions.
namespace askhardware {

/// @return the timer's rate in ticks a second.
uint32_t ticksPerSecond();

/// Sets up pins and timer and calls the radio's onEdge() and onAlarm() from now on.
/// @return false where there is no such pin, the RX pin has no pin-change interrupt, or the timer is taken.
bool begin(uint8_t rxPin, uint8_t txPin, AskRadio &radio);

/// Whether another part of the sketch uses the timer too.
/// @return flags of a poll's reply: the timer's number plus 1 in bits 4 to 6; or 0
uint8_t takenTimer();

/// The timer; counts up and around.
uint16_t now();

/// Has onAlarm() called when the timer gets to this value, which is less than a round ahead; replaces any other alarm.
void setAlarm(uint16_t at);

/// After this no alarm is pending.
void clearAlarm();

/// Whether onEdge() is called when the RX pin changes; changes from before do not count.
void watchEdges(bool on);

/// Switches the carrier.
void transmit(bool on);

/// Keeps the radio's interrupts away while it lives.
class InterruptLock {
 public:
  InterruptLock();
  ~InterruptLock();

 private:
  InterruptLock(const InterruptLock &);
  InterruptLock &operator=(const InterruptLock &);
  const uint8_t before_;
};

}  // namespace askhardware
}  // namespace javinolib
