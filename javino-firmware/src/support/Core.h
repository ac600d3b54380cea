#pragma once

/// The Arduino core, for each file of the library that needs it: those of its macros that are named like ours are set aside.

#include <Arduino.h>

#include "SketchMacros.inc"
