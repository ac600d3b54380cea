#pragma once

/// JavinoBDI: connects a BDI agent to this board's sensors, actuators and radio. See the README.

#include <Arduino.h>

#include "support/SketchMacros.inc"

#include "arduino/ArduinoBoard.h"
#include "delivery/AirtimeLimit.h"
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

// Beside JavinoBoard and JavinoRadioBoard, the names for sketches.
using JavinoPercepts = javinolib::Percepts;
using JavinoArguments = javinolib::Arguments;
using JavinoResult = javinolib::Result;
using JavinoBroadcaster = javinolib::Broadcaster;
using JavinoRelay = javinolib::Relay;
using JavinoAskRadio = javinolib::AskRadio;
using JavinoAirtimeLimit = javinolib::AirtimeLimit;
using JavinoSerialRadio = javinolib::SerialRadio;
using JavinoSerialModule = javinolib::SerialModule;

// And for a driver of another radio.
using JavinoRadio = javinolib::Radio;
using JavinoReceived = javinolib::Received;
using JavinoRadioCounters = javinolib::RadioCounters;

// And of another memory.
using JavinoEeprom = javinolib::Eeprom;

JAVINO_EACH_NAME(JAVINO_BRING_BACK)
#undef JAVINO_MACROS_ARE_ASIDE
