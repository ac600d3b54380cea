#pragma once

/// The class of the published library, for its sketches. Others include JavinoBDI.h.

#include <Arduino.h>

#include "support/SketchMacros.inc"

#include "arduino/PublishedJavino.h"

JAVINO_EACH_NAME(JAVINO_BRING_BACK)
#undef JAVINO_MACROS_ARE_ASIDE
