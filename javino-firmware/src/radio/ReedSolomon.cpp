#include "ReedSolomon.h"

#include <string.h>

#include "../support/Flash.h"

namespace javinolib {
namespace reedsolomon {

namespace {

// These two take 512 bytes of flash. Without them a product takes 140 cycles instead of 30: the parity of 80 bytes 178 000
// instead of 37 000.
const uint8_t POWERS[256] JAVINO_FLASH = {
    0x01, 0x02, 0x04, 0x08, 0x10, 0x20, 0x40, 0x80, 0x1D, 0x3A, 0x74, 0xE8, 0xCD, 0x87, 0x13, 0x26, 0x4C, 0x98, 0x2D,
    0x5A, 0xB4, 0x75, 0xEA, 0xC9, 0x8F, 0x03, 0x06, 0x0C, 0x18, 0x30, 0x60, 0xC0, 0x9D, 0x27, 0x4E, 0x9C, 0x25, 0x4A,
    0x94, 0x35, 0x6A, 0xD4, 0xB5, 0x77, 0xEE, 0xC1, 0x9F, 0x23, 0x46, 0x8C, 0x05, 0x0A, 0x14, 0x28, 0x50, 0xA0, 0x5D,
    0xBA, 0x69, 0xD2, 0xB9, 0x6F, 0xDE, 0xA1, 0x5F, 0xBE, 0x61, 0xC2, 0x99, 0x2F, 0x5E, 0xBC, 0x65, 0xCA, 0x89, 0x0F,
    0x1E, 0x3C, 0x78, 0xF0, 0xFD, 0xE7, 0xD3, 0xBB, 0x6B, 0xD6, 0xB1, 0x7F, 0xFE, 0xE1, 0xDF, 0xA3, 0x5B, 0xB6, 0x71,
    0xE2, 0xD9, 0xAF, 0x43, 0x86, 0x11, 0x22, 0x44, 0x88, 0x0D, 0x1A, 0x34, 0x68, 0xD0, 0xBD, 0x67, 0xCE, 0x81, 0x1F,
    0x3E, 0x7C, 0xF8, 0xED, 0xC7, 0x93, 0x3B, 0x76, 0xEC, 0xC5, 0x97, 0x33, 0x66, 0xCC, 0x85, 0x17, 0x2E, 0x5C, 0xB8,
    0x6D, 0xDA, 0xA9, 0x4F, 0x9E, 0x21, 0x42, 0x84, 0x15, 0x2A, 0x54, 0xA8, 0x4D, 0x9A, 0x29, 0x52, 0xA4, 0x55, 0xAA,
    0x49, 0x92, 0x39, 0x72, 0xE4, 0xD5, 0xB7, 0x73, 0xE6, 0xD1, 0xBF, 0x63, 0xC6, 0x91, 0x3F, 0x7E, 0xFC, 0xE5, 0xD7,
    0xB3, 0x7B, 0xF6, 0xF1, 0xFF, 0xE3, 0xDB, 0xAB, 0x4B, 0x96, 0x31, 0x62, 0xC4, 0x95, 0x37, 0x6E, 0xDC, 0xA5, 0x57,
    0xAE, 0x41, 0x82, 0x19, 0x32, 0x64, 0xC8, 0x8D, 0x07, 0x0E, 0x1C, 0x38, 0x70, 0xE0, 0xDD, 0xA7, 0x53, 0xA6, 0x51,
    0xA2, 0x59, 0xB2, 0x79, 0xF2, 0xF9, 0xEF, 0xC3, 0x9B, 0x2B, 0x56, 0xAC, 0x45, 0x8A, 0x09, 0x12, 0x24, 0x48, 0x90,
    0x3D, 0x7A, 0xF4, 0xF5, 0xF7, 0xF3, 0xFB, 0xEB, 0xCB, 0x8B, 0x0B, 0x16, 0x2C, 0x58, 0xB0, 0x7D, 0xFA, 0xE9, 0xCF,
    0x83, 0x1B, 0x36, 0x6C, 0xD8, 0xAD, 0x47, 0x8E, 0x01};

// The logarithms of bytes to base alpha; 0 has none.
const uint8_t LOGARITHMS[256] JAVINO_FLASH = {
    0x00, 0x00, 0x01, 0x19, 0x02, 0x32, 0x1A, 0xC6, 0x03, 0xDF, 0x33, 0xEE, 0x1B, 0x68, 0xC7, 0x4B, 0x04, 0x64, 0xE0,
    0x0E, 0x34, 0x8D, 0xEF, 0x81, 0x1C, 0xC1, 0x69, 0xF8, 0xC8, 0x08, 0x4C, 0x71, 0x05, 0x8A, 0x65, 0x2F, 0xE1, 0x24,
    0x0F, 0x21, 0x35, 0x93, 0x8E, 0xDA, 0xF0, 0x12, 0x82, 0x45, 0x1D, 0xB5, 0xC2, 0x7D, 0x6A, 0x27, 0xF9, 0xB9, 0xC9,
    0x9A, 0x09, 0x78, 0x4D, 0xE4, 0x72, 0xA6, 0x06, 0xBF, 0x8B, 0x62, 0x66, 0xDD, 0x30, 0xFD, 0xE2, 0x98, 0x25, 0xB3,
    0x10, 0x91, 0x22, 0x88, 0x36, 0xD0, 0x94, 0xCE, 0x8F, 0x96, 0xDB, 0xBD, 0xF1, 0xD2, 0x13, 0x5C, 0x83, 0x38, 0x46,
    0x40, 0x1E, 0x42, 0xB6, 0xA3, 0xC3, 0x48, 0x7E, 0x6E, 0x6B, 0x3A, 0x28, 0x54, 0xFA, 0x85, 0xBA, 0x3D, 0xCA, 0x5E,
    0x9B, 0x9F, 0x0A, 0x15, 0x79, 0x2B, 0x4E, 0xD4, 0xE5, 0xAC, 0x73, 0xF3, 0xA7, 0x57, 0x07, 0x70, 0xC0, 0xF7, 0x8C,
    0x80, 0x63, 0x0D, 0x67, 0x4A, 0xDE, 0xED, 0x31, 0xC5, 0xFE, 0x18, 0xE3, 0xA5, 0x99, 0x77, 0x26, 0xB8, 0xB4, 0x7C,
    0x11, 0x44, 0x92, 0xD9, 0x23, 0x20, 0x89, 0x2E, 0x37, 0x3F, 0xD1, 0x5B, 0x95, 0xBC, 0xCF, 0xCD, 0x90, 0x87, 0x97,
    0xB2, 0xDC, 0xFC, 0xBE, 0x61, 0xF2, 0x56, 0xD3, 0xAB, 0x14, 0x2A, 0x5D, 0x9E, 0x84, 0x3C, 0x39, 0x53, 0x47, 0x6D,
    0x41, 0xA2, 0x1F, 0x2D, 0x43, 0xD8, 0xB7, 0x7B, 0xA4, 0x76, 0xC4, 0x17, 0x49, 0xEC, 0x7F, 0x0C, 0x6F, 0xF6, 0x6C,
    0xA1, 0x3B, 0x52, 0x29, 0x9D, 0x55, 0xAA, 0xFB, 0x60, 0x86, 0xB1, 0xBB, 0xCC, 0x3E, 0x5A, 0xCB, 0x59, 0x5F, 0xB0,
    0x9C, 0xA9, 0xA0, 0x51, 0x0B, 0xF5, 0x16, 0xEB, 0x7A, 0x75, 0x2C, 0xD7, 0x4F, 0xAE, 0xD5, 0xE9, 0xE6, 0xE7, 0xAD,
    0xE8, 0x74, 0xD6, 0xF4, 0xEA, 0xA8, 0x50, 0x58, 0xAF};

// The generator's coefficients below the highest, as logarithms: (x - alpha) (x - alpha^2) ... (x - alpha^16).
const uint8_t GENERATOR[PARITY_LENGTH] JAVINO_FLASH = {121, 106, 110, 113, 107, 167, 83,  11,
                                                       100, 201, 158, 181, 195, 208, 240, 136};

const uint8_t ORDER = 255;  // alpha^255 = 1

// The share of each phase that one step does, so that none takes more than 40 000 cycles.
const uint8_t SYNDROMES_A_STEP = 4;
const uint8_t ROUNDS_A_STEP = 4;
const uint8_t POSITIONS_A_STEP = 32;

uint8_t power(uint8_t exponent) { return flashByte(POWERS + exponent); }

uint8_t logarithm(uint8_t value) { return flashByte(LOGARITHMS + value); }

// A sum of exponents 0...255, modulo 255; the result may be 255 too, which POWERS has.
uint8_t addExponents(uint8_t a, uint8_t b) {
#ifdef __AVR__
  __asm__("add %0, %1\n\tadc %0, __zero_reg__" : "+r"(a) : "r"(b));  // a tenth fewer cycles
  return a;
#else
  const uint16_t sum = static_cast<uint16_t>(a + b);
  return static_cast<uint8_t>(sum + (sum >> 8));
#endif
}

// value * alpha^exponent
uint8_t timesPower(uint8_t value, uint8_t exponent) {
  return value == 0 ? 0 : power(addExponents(logarithm(value), exponent));
}

uint8_t product(uint8_t a, uint8_t b) { return b == 0 ? 0 : timesPower(a, logarithm(b)); }

// The polynomial's value at alpha^exponent, its highest coefficient last.
uint8_t valueAt(const uint8_t *coefficients, uint8_t count, uint8_t exponent) {
  uint8_t value = 0;
  while (count-- > 0) value = static_cast<uint8_t>(timesPower(value, exponent) ^ coefficients[count]);
  return value;
}

}  // namespace

void encode(const uint8_t *bytes, uint8_t length, uint8_t *parity) {
  memset(parity, 0, PARITY_LENGTH);
  for (; length > 0; length--) {
    const uint8_t highest = static_cast<uint8_t>(*bytes++ ^ parity[0]);
    const uint8_t exponent = logarithm(highest);
    const uint8_t mask = highest == 0 ? 0 : 0xFF;
    uint8_t shifted = 0;
    uint8_t *at = parity + PARITY_LENGTH;
    for (uint8_t i = PARITY_LENGTH; i-- > 0;) {
      const uint8_t here = *--at;
      *at = static_cast<uint8_t>(shifted ^ (power(addExponents(exponent, flashByte(GENERATOR + i))) & mask));
      shifted = here;
    }
  }
}

void Decoder::begin(uint8_t *codeword, uint8_t length) {
  codeword_ = codeword;
  length_ = length;
  erasures_ = 0;
  memset(locator_, 0, sizeof locator_);
  locator_[0] = 1;
  enter(Phase::SYNDROMES);
}

void Decoder::erase(uint8_t position) {
  if (phase_ != Phase::SYNDROMES || position >= length_ || erasures_ > PARITY_LENGTH) return;
  const uint8_t exponent = exponentOf(position);
  const bool isKnown = valueAt(locator_, static_cast<uint8_t>(erasures_ + 1), ORDER - exponent) == 0;
  if (isKnown) return;
  erasures_++;
  if (erasures_ > PARITY_LENGTH) return;
  for (uint8_t i = erasures_; i > 0; i--) locator_[i] ^= timesPower(locator_[i - 1], exponent);
}

Progress Decoder::step() {
  switch (phase_) {
    case Phase::SYNDROMES: computeSyndromes(); break;
    case Phase::LOCATOR: extendLocator(); break;
    case Phase::POSITIONS: findPositions(); break;
    case Phase::VALUES: correct(); break;
    case Phase::ENDED: break;
  }
  return phase_ == Phase::ENDED ? progress_ : Progress::PENDING;
}

void Decoder::enter(Phase phase) {
  phase_ = phase;
  next_ = 0;
}

void Decoder::end(Progress progress) {
  progress_ = progress;
  enter(Phase::ENDED);
}

// The received word's values at the generator's roots: all 0 for a codeword.
void Decoder::computeSyndromes() {
  if (length_ <= PARITY_LENGTH || erasures_ > PARITY_LENGTH) return end(Progress::FAILED);
  const uint8_t until = static_cast<uint8_t>(next_ + SYNDROMES_A_STEP);
  for (; next_ < until; next_++) {
    uint8_t syndrome = 0;
    for (uint8_t i = 0; i < length_; i++)
      syndrome = static_cast<uint8_t>(timesPower(syndrome, static_cast<uint8_t>(next_ + 1)) ^ codeword_[i]);
    syndromes_[next_] = syndrome;
  }
  if (next_ < PARITY_LENGTH) return;
  uint8_t any = 0;
  for (uint8_t syndrome : syndromes_) any |= syndrome;
  if (any == 0) return end(Progress::CORRECTED);
  enter(Phase::LOCATOR);
  next_ = erasures_;
  degree_ = erasures_;
  memcpy(scratch_, locator_, sizeof scratch_);
}

// Berlekamp and Massey's algorithm, which begins with the erasures' locator.
void Decoder::extendLocator() {
  for (uint8_t left = ROUNDS_A_STEP; left > 0 && next_ < PARITY_LENGTH; left--, next_++) {
    memmove(scratch_ + 1, scratch_, PARITY_LENGTH);
    scratch_[0] = 0;
    uint8_t discrepancy = 0;
    for (uint8_t i = 0; i <= degree_; i++) discrepancy ^= product(locator_[i], syndromes_[next_ - i]);
    if (discrepancy == 0) continue;
    const uint8_t exponent = logarithm(discrepancy);
    const bool grows = 2 * degree_ <= next_ + erasures_;
    for (uint8_t i = 0; i <= PARITY_LENGTH; i++) {
      const uint8_t before = locator_[i];
      locator_[i] ^= timesPower(scratch_[i], exponent);
      if (grows) scratch_[i] = timesPower(before, ORDER - exponent);
    }
    if (grows) degree_ = static_cast<uint8_t>(next_ + 1 + erasures_ - degree_);
  }
  if (next_ < PARITY_LENGTH) return;
  if (2 * degree_ > PARITY_LENGTH + erasures_) return end(Progress::FAILED);
  found_ = 0;
  enter(Phase::POSITIONS);
}

// The locator is 0 at the inverse of each wrong byte's power of alpha. It must have all its roots within the codeword.
void Decoder::findPositions() {
  for (uint8_t left = POSITIONS_A_STEP; left > 0 && next_ < length_; left--, next_++) {
    const uint8_t exponent = exponentOf(next_);
    if (valueAt(locator_, static_cast<uint8_t>(degree_ + 1), ORDER - exponent) != 0) continue;
    scratch_[found_++] = exponent;
  }
  if (next_ < length_) return;
  if (found_ != degree_) return end(Progress::FAILED);
  enter(Phase::VALUES);
}

// Forney's algorithm. As all roots differ, the locator's derivative is 0 at none of them.
void Decoder::correct() {
  uint8_t *const evaluator = syndromes_;
  for (uint8_t k = degree_; k-- > 0;) {
    uint8_t sum = 0;
    for (uint8_t i = 0; i <= k; i++) sum ^= product(locator_[i], syndromes_[k - i]);
    evaluator[k] = sum;
  }
  for (uint8_t i = 0; i < found_; i++) {
    const uint8_t inverse = static_cast<uint8_t>(ORDER - scratch_[i]);
    const uint8_t square = addExponents(inverse, inverse);
    uint8_t derivative = 0;
    for (uint8_t k = static_cast<uint8_t>((degree_ - 1) | 1); k <= PARITY_LENGTH; k = static_cast<uint8_t>(k - 2))
      derivative = static_cast<uint8_t>(timesPower(derivative, square) ^ locator_[k]);
    const uint8_t value = valueAt(evaluator, degree_, inverse);
    codeword_[length_ - 1 - scratch_[i]] ^= timesPower(value, static_cast<uint8_t>(ORDER - logarithm(derivative)));
  }
  end(Progress::CORRECTED);
}

}  // namespace reedsolomon
}  // namespace javinolib
