// SPDX-License-Identifier: GPL-3.0-or-later
#include "propagation.h"

#include <math.h>

#include "prng.h"

// Stream numbers of the seed from here on are those of pairs.
#define PAIR_STREAM 4000
#define MOST_SOURCES 64
// The rate that 0 counts as where it rises to another one, as its logarithm is no number: a bit in six days.
#define LEAST_RATE 1e-9

// How many times as far a signal comes from that is so much weaker.
static double times_as_far(double db) { return pow(10, db / (10 * PATH_LOSS_EXPONENT)); }

double propagation_metres(const radio_config *radio, uint64_t seed, size_t one, size_t other, double distance_m) {
  if (radio->shadowing_db <= 0) return distance_m;
  size_t low = one < other ? one : other;
  prng generator;
  prng_seed(&generator, seed, PAIR_STREAM + low * MOST_SOURCES + (one + other - low));
  return distance_m * times_as_far(radio->shadowing_db * prng_normal(&generator));
}

static double log_rate(const distance_rate *point) { return log(fmax(point->rate, LEAST_RATE)); }

double propagation_error_rate(const radio_config *radio, double metres) {
  const distance_rate *points = radio->distance_rates;
  size_t passed = 0;
  while (passed < radio->distance_rate_count && points[passed].metres <= metres) passed++;
  if (radio->distance_rate_count == 0) return 0;
  if (passed == 0 || passed == radio->distance_rate_count) return points[passed ? passed - 1 : 0].rate;
  const distance_rate *before = &points[passed - 1], *after = &points[passed];
  if (before->rate == after->rate) return before->rate;
  double share = (metres - before->metres) / (after->metres - before->metres);
  return exp(log_rate(before) + share * (log_rate(after) - log_rate(before)));
}

double propagation_capture_ratio(const radio_config *radio) { return times_as_far(radio->capture_db); }
