#pragma once

/// Javino for Arduino: connects a BDI agent to this board's sensors, actuators and radio. See the README.

#include "arduino/JavinoBoard.h"
#include "delivery/Broadcaster.h"
#include "radio/AskRadio.h"

// A sketch that wants the radio on another timer than 1 says so, in one of its files, before it includes this one:
// #define JAVINO_RADIO_TIMER 3
#ifdef JAVINO_RADIO_TIMER
#include "radio/AskHardwareAvrTimer.h"
#endif
