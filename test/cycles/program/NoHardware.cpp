// The radio's hardware, which does nothing: the program itself calls the interrupts.

#include "radio/AskHardware.h"

namespace javinolib {
namespace askhardware {

uint32_t ticksPerSecond() { return 2000000; }
bool begin(uint8_t, uint8_t, AskRadio &) { return true; }
uint16_t now() { return 0; }
void setAlarm(uint16_t) {}
void clearAlarm() {}
void watchEdges(bool) {}
void transmit(bool) {}
InterruptLock::InterruptLock() : before_(0) {}
InterruptLock::~InterruptLock() {}

}  // namespace askhardware
}  // namespace javinolib
