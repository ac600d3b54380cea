#pragma once

/// The types of the Arduino core that the other parts name. AVR's core, and the tests, which have none, let them be declared
/// here, so that these parts need no Arduino header; other cores have them in a namespace.
#if defined(ARDUINO) && !defined(ARDUINO_ARCH_AVR)
#include "Core.h"
#else
class Stream;
class __FlashStringHelper;
#endif
