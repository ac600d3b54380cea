#pragma once

/// Javino.h, under a name that the published library of the same name does not have: for sketchbooks that hold both.

#include "Javino.h"
