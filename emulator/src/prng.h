// SPDX-License-Identifier: GPL-3.0-or-later
// Pseudo-random numbers: xoshiro256** (Blackman and Vigna, 2018), seeded by splitmix64.
#ifndef JAVINO_PRNG_H
#define JAVINO_PRNG_H

#include <stdint.h>

typedef struct {
  uint64_t state[4];
} prng;

// Starts stream number `stream` of `seed`; streams of one seed are independent of each other.
void prng_seed(prng *generator, uint64_t seed, uint64_t stream);

// The next 64 random bits.
uint64_t prng_next(prng *generator);

// A number from 0 to below 1.
double prng_uniform(prng *generator);

// True with the given probability, 0…1.
int prng_chance(prng *generator, double probability);

// How long until something that happens at any time with the same chance, with this mean.
double prng_exponential(prng *generator, double mean);

// A number of the normal distribution, with mean 0 and standard deviation 1.
double prng_normal(prng *generator);

#endif
