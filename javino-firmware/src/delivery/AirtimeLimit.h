#pragma once

#include <stddef.h>
#include <stdint.h>

#include "../radio/Radio.h"
#include "../support/Trace.h"
#include "../support/Zeroed.h"

namespace javinolib {

/// A radio that sends for no more than a share of each hour (SPEC 7.6): it refuses packets beyond, which wait. The level is in
/// RAM that a reset leaves alone; after a loss of power all is spent.
/// On an AVR a global or static object (support/Zeroed.h).
class AirtimeLimit final : public Radio {
 public:
  static void *operator new(size_t) = delete;

  // The radio outlives it. The percent of an hour: 1…100.
  AirtimeLimit(Radio &radio, uint8_t percent) : radio_(radio), percent_(percent) {}

  bool begin() override {
    trace::tell(trace::AIRTIME_LIMIT, percent_);
    return radio_.begin();
  }
  bool send(const uint8_t *payload, uint8_t length) override;
#if JAVINO_LARGE
  uint8_t follow(Trailer trailer, uint8_t length) override { return follows_ = radio_.follow(trailer, length); }
#endif
  uint8_t *sentPath() override { return radio_.sentPath(); }
  Mender *mender() override { return radio_.mender(); }
  bool sending() const override { return radio_.sending(); }
  bool carrier() const override { return radio_.carrier(); }
  uint8_t longestPayload() const override { return radio_.longestPayload(); }
  uint16_t airtimeMillis(uint8_t length) const override { return radio_.airtimeMillis(length); }
  uint8_t slotMillis() const override { return radio_.slotMillis(); }
  uint8_t *receive(Received &with) override { return radio_.receive(with); }
  void release() override { radio_.release(); }
  void counters(RadioCounters &into) const override;
  bool idle() const override { return radio_.idle(); }

 private:
  uint32_t capacity() const;
  uint32_t costOf(uint8_t length) const;
  uint32_t reserveFrom(const uint8_t *payload, uint32_t cost) const;
  uint32_t level() const;
  void keep(uint32_t level) const;

  Radio &radio_;
  const uint8_t percent_;
  uint8_t follows_ JAVINO_ZEROED;            // the trailer of the next packet, in bytes
  mutable uint32_t lookedAt_ JAVINO_ZEROED;  // when the level was as it is kept
};

}  // namespace javinolib
