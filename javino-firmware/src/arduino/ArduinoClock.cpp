#include <Arduino.h>

#include "../support/Clock.h"

namespace javino {
namespace clock {

uint32_t millis() { return ::millis(); }

}  // namespace clock
}  // namespace javino
