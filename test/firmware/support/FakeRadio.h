#pragma once

#include <radio/Radio.h>

#include <deque>
#include <vector>

#include "Bytes.h"

/// A radio in memory: the test lets packets arrive, sees what is sent, and says when it is sent.
class FakeRadio : public javino::Radio {
 public:
  bool begin() override { return works; }
  bool send(const uint8_t *payload, uint8_t length) override;
  bool sending() const override { return onAir_; }
  bool carrier() const override { return heard; }
  uint8_t longestPayload() const override { return payload; }
  uint16_t airtimeMillis(uint8_t length) const override { return static_cast<uint16_t>(42 + 6 * length); }
  uint8_t slotMillis() const override { return 8; }
  uint8_t *receive(uint8_t &length) override;
  void release() override { in_.pop_front(); }
  void counters(javino::RadioCounters &into) const override { into = counts; }
  bool idle() const override { return in_.empty(); }

  void arrive(const Bytes &payload) { in_.push_back(payload); }

  /// The packet on the air ends.
  void finishSending();

  bool works = true;     ///< whether begin() succeeds
  bool refuses = false;  ///< whether send() does nothing
  bool heard = false;    ///< whether another board's carrier is on the air
  uint8_t payload = javino::MAX_RADIO_PAYLOAD;
  javino::RadioCounters counts = {0, 0, 0, 0, 0};
  std::vector<Bytes> sent;

 private:
  std::deque<Bytes> in_;
  bool onAir_ = false;
};
