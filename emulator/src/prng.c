// SPDX-License-Identifier: GPL-3.0-or-later
#include "prng.h"

#include <math.h>

static uint64_t rotate_left(uint64_t x, int bits) { return (x << bits) | (x >> (64 - bits)); }

static uint64_t splitmix64(uint64_t *state) {
  uint64_t z = (*state += 0x9E3779B97F4A7C15u);
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return z ^ (z >> 31);
}

void prng_seed(prng *generator, uint64_t seed, uint64_t stream) {
  uint64_t state = seed;
  // The stream number goes through the mixer too, so that neighbours share nothing.
  state = splitmix64(&state) + stream;
  for (int i = 0; i < 4; i++) generator->state[i] = splitmix64(&state);
}

uint64_t prng_next(prng *generator) {
  uint64_t *s = generator->state;
  uint64_t result = rotate_left(s[1] * 5, 7) * 9;
  uint64_t t = s[1] << 17;
  s[2] ^= s[0];
  s[3] ^= s[1];
  s[1] ^= s[2];
  s[0] ^= s[3];
  s[2] ^= t;
  s[3] = rotate_left(s[3], 45);
  return result;
}

// 53 bits are all that a double can hold.
double prng_uniform(prng *generator) { return (double)(prng_next(generator) >> 11) * 0x1.0p-53; }

// 0 is never a hit, 1 always.
int prng_chance(prng *generator, double probability) { return prng_uniform(generator) < probability; }

double prng_exponential(prng *generator, double mean) { return -mean * log1p(-prng_uniform(generator)); }

// Box and Muller's method.
double prng_normal(prng *generator) {
  double length = sqrt(prng_exponential(generator, 2));
  return length * cos(2 * M_PI * prng_uniform(generator));
}
