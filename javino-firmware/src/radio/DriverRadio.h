#pragma once

#include <stdint.h>

#include "../support/Clock.h"
#include "../support/Counters.h"
#include "../support/Zeroed.h"
#include "AirRate.h"
#include "Radio.h"

namespace javinolib {

/// What the radios over other libraries' drivers share: times, counts, and the place of a packet that came. On an AVR a global or
/// static object (support/Zeroed.h).
class DriverRadio : public Radio {
 public:
  bool sending() const override { return sending_; }
  uint8_t longestPayload() const override { return longestPayload_; }
  uint16_t airtimeMillis(uint8_t length) const override {
    return rate_.millis(static_cast<uint16_t>(length + beside_));
  }
  uint8_t slotMillis() const override { return slotMillis_; }
  uint8_t *sentPath() override { return &sentPath_; }
  void release() override { waits_ = false; }
  void counters(RadioCounters &into) const override { into = counters_; }
  bool idle() const override { return !waits_; }

 protected:
  /// @param beside bytes of a packet beside its payload
  DriverRadio(const AirRate &rate, uint8_t beside)
      : rate_(rate), beside_(beside), longestPayload_(MIN_RADIO_PAYLOAD), slotMillis_(UINT8_MAX) {}
  ~DriverRadio() = default;

  /// Sets what the interface tells of the radio.
  /// @param longestPayload that the chip can carry
  /// @param hears whether a packet on the air is known before its end
  /// @return false if the chip carries too little, or if it is too slow: the longest packet takes more than MOST_MILLIS, or a
  /// carrier is heard only after 255 ms
  bool measure(uint16_t longestPayload, bool hears);

  bool takes(uint8_t length) const { return !sending_ && length != 0 && length <= longestPayload_; }

  /// A packet begins.
  void begun(uint8_t length) {
    sending_ = true;
    airtime_ = airtimeMillis(length);
    since_ = now();
  }

  /// Whether a packet that ought to have ended did not: an interrupt was lost, or the driver has none.
  bool isOverdue() const { return elapsed() > airtime_ + airtime_ / 2 + 10u; }

  /// The packet on the air has ended.
  void ended() {
    sending_ = false;
    countUp(counters_.sent);
  }

  static uint16_t now() { return static_cast<uint16_t>(clock::millis()); }
  uint16_t elapsed() const { return static_cast<uint16_t>(now() - since_); }

  AirRate rate_;
  uint16_t since_ JAVINO_ZEROED;  // when what the chip does now began
  uint16_t airtime_ JAVINO_ZEROED;
  const uint8_t beside_;
  uint8_t longestPayload_;
  uint8_t slotMillis_;
  uint8_t sentPath_ JAVINO_ZEROED;
  bool sending_ JAVINO_ZEROED;
  bool waits_ JAVINO_ZEROED;  // a packet, for release()
  mutable RadioCounters counters_ JAVINO_ZEROED;

 private:
  static const uint16_t MOST_MILLIS = 4000;  // a relay's store of time (SPEC 7.5)
};

// A chip hears a packet during the first fifth of what surrounds a payload: 5 symbols of LoRa's, 2 bytes of FSK. If it does
// not, the six slots that a sender waits hold an acknowledgement.
inline bool DriverRadio::measure(uint16_t longestPayload, bool hears) {
  longestPayload_ = static_cast<uint8_t>(longestPayload < MAX_RADIO_PAYLOAD ? longestPayload : MAX_RADIO_PAYLOAD);
  const uint16_t heardAfter = hears ? rate_.millis(0) : airtimeMillis(MIN_RADIO_PAYLOAD);
  const uint16_t slot = static_cast<uint16_t>(heardAfter / 5 + 2);
  const bool fits =
      longestPayload_ >= MIN_RADIO_PAYLOAD && slot <= UINT8_MAX && airtimeMillis(longestPayload_) <= MOST_MILLIS;
  if (!fits) longestPayload_ = MIN_RADIO_PAYLOAD;
  slotMillis_ = static_cast<uint8_t>(fits ? slot : UINT8_MAX);
  return fits;
}

}  // namespace javinolib
