#pragma once

/// Javino for Arduino: connects a BDI agent to this board's sensors, actuators and radio. See the README.

#include "arduino/JavinoBoard.h"
#include "radio/AskRadio.h"
