// SPDX-License-Identifier: GPL-3.0-or-later
// The fate of a signal on its way: how weak it is, in metres, and how many of its bits are wrong.
//
// Strength is told as a distance: that at which a signal would be as weak without anything in its way. So range, errors and
// capture all see the same loss. It falls by PATH_LOSS_EXPONENT × 10 dB from a metre to ten.
#ifndef JAVINO_PROPAGATION_H
#define JAVINO_PROPAGATION_H

#include <stddef.h>
#include <stdint.h>

#include "scenario.h"

#define PATH_LOSS_EXPONENT 3

// The distance with what stands between two places, the same both ways: what shadows one of two sources from the other is
// seeded for each pair.
double propagation_metres(const radio_config *radio, uint64_t seed, size_t one, size_t other, double distance_m);

// The share of wrong bits of a signal from so far: between two points of the table by the logarithm of the rate.
double propagation_error_rate(const radio_config *radio, double metres);

// How many times as far the weaker of two signals comes from that does not disturb the stronger one.
double propagation_capture_ratio(const radio_config *radio);

#endif
