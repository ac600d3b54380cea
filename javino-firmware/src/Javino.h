#pragma once

/// Javino for Arduino: connects a BDI agent to this board's sensors, actuators and radio. See the README.

#include <Arduino.h>

#include "support/SketchMacros.inc"

#include "arduino/ArduinoBoard.h"
#include "arduino/PublishedJavino.h"
#include "delivery/Broadcaster.h"
#include "delivery/Relay.h"
#include "radio/AskHardware.h"
#include "serialradio/SerialRadio.h"

#ifdef JAVINO_HAS_ASK_HARDWARE
#include "radio/AskRadio.h"

// For a radio on another timer than 1, write this in one file of the sketch, before this header is included:
// #define JAVINO_RADIO_TIMER 3
#ifdef JAVINO_RADIO_TIMER
#include "radio/AskHardwareAvrTimer.h"
#endif

#else
#include "radio/NoAskRadio.h"
#endif

JAVINO_EACH_NAME(JAVINO_BRING_BACK)
