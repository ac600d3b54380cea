#pragma once

/// The two primitives under Aes128, each in two implementations: assembly for AVR (Aes128Avr.S), C++ for all others
/// (Aes128Portable.cpp). This file is included by C++ and by assembly.

#include "../Config.h"

// Devices whose core has MOVW and LPM to any register: all ATmegas.
#if defined(__AVR_HAVE_MOVW__) && defined(__AVR_HAVE_LPMX__) && !defined(__AVR_TINY__)
#define JAVINO_AES_IN_ASSEMBLY 1
#else
#define JAVINO_AES_IN_ASSEMBLY 0
#endif

// Room for all round keys, or for the one under way and the first.
#if JAVINO_LARGE
#define JAVINO_ROUND_KEYS_LENGTH 176
#else
#define JAVINO_ROUND_KEYS_LENGTH 32
// Names of their own: a program whose files were compiled with different profiles does not link.
#define javino_aes128_expand javino_aes128_expand_small
#define javino_aes128_encrypt javino_aes128_encrypt_small
#endif

#ifndef __ASSEMBLER__

#include <stdint.h>

extern "C" {

/// Expands a key of 16 bytes to 11 round keys, 176 bytes (FIPS 197 section 5.2); or, on a small board, copies it
/// behind the room for one.
void javino_aes128_expand(uint8_t *roundKeys, const uint8_t *key);

/// Encrypts 16 bytes (FIPS 197 section 5.1); `in` and `out` may be the same place, but not overlap otherwise.
void javino_aes128_encrypt(uint8_t *roundKeys, const uint8_t *in, uint8_t *out);

#if JAVINO_LARGE
/// Encrypts the 16 bytes at `in` and adds (XOR) the result to the 16 bytes at `onto`: the step of a chain. The next step
/// is `back` bytes before the end of these, with the 16 bytes before it as `in`; the chain ends before a step at `stop`.
/// @param back 0 to go up block by block, 32 to go down
/// @param stop a multiple of 16 bytes behind `onto` to go up, before it to go down, and not `onto` itself
void javino_aes128_chain(uint8_t *roundKeys, const uint8_t *in, uint8_t *onto, const uint8_t *stop, uint8_t back);
#endif
}

#endif
