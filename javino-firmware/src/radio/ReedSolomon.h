#pragma once

#include <stdint.h>

namespace javinolib {

/// Parity that mends a packet (SPEC 6.1): the Reed-Solomon code (255, 239) of FX.25, shortened. A codeword is up to 239 bytes
/// and behind them their parity.
namespace reedsolomon {

static const uint8_t PARITY_LENGTH = 16;

/// @param length 1…239
/// @param parity becomes the 16 bytes that follow these.
void encode(const uint8_t *bytes, uint8_t length, uint8_t *parity);

enum class Progress : uint8_t {
  PENDING,    ///< step() has more to do
  CORRECTED,  ///< the bytes are a codeword now. With as many erasures as parity any bytes become one: a CRC has to judge
  FAILED      ///< too much is wrong; nothing was changed
};

/// Mends a codeword in steps of at most 40 000 cycles. With f erasures, it finds e wrong bytes more where 2 e + f ≤ 16.
class Decoder {
 public:
  /// @param codeword stays the caller's, and as it is, until step() has ended
  /// @param length of it with the parity, 17…255
  void begin(uint8_t *codeword, uint8_t length);

  /// Says, before the first step, that the byte there is not to be relied on. One that was named already, that is behind the end, or that
  /// comes later is ignored.
  void erase(uint8_t position);

  /// Does the next part of the work.
  Progress step();

 private:
  enum class Phase : uint8_t { SYNDROMES, LOCATOR, POSITIONS, VALUES, ENDED };

  void computeSyndromes();
  void extendLocator();
  void findPositions();
  void correct();
  void enter(Phase phase);
  void end(Progress progress);
  uint8_t exponentOf(uint8_t position) const { return static_cast<uint8_t>(length_ - 1 - position); }

  uint8_t *codeword_;
  uint8_t length_;
  Phase phase_;
  Progress progress_;
  uint8_t next_;      // what the phase goes on with
  uint8_t erasures_;  // PARITY_LENGTH + 1 for more
  uint8_t degree_;    // of the locator
  uint8_t found_;     // positions
  uint8_t syndromes_[PARITY_LENGTH];
  uint8_t locator_[PARITY_LENGTH + 1];  // has a root for each wrong byte; the lowest coefficient first
  uint8_t scratch_[PARITY_LENGTH + 1];  // the locator's correction, then the exponents of the positions found
};

}  // namespace reedsolomon
}  // namespace javinolib
