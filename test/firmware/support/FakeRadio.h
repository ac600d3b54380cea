#pragma once

#include <radio/Mender.h>
#include <radio/RadioEncoder.h>

#include <deque>
#include <functional>
#include <set>
#include <utility>
#include <vector>

#include "Bytes.h"

/// A radio in memory: the test lets packets arrive, sees what is sent, and says when it is sent. One that mends takes packets as
/// they come from the air, as an AskRadio does.
class FakeRadio : public javinolib::Radio {
 public:
  bool begin() override { return works; }
  bool send(const uint8_t *payload, uint8_t length) override;
  bool sending() const override { return onAir_; }
  bool carrier() const override { return std::exchange(wasHeard, false) || heard; }
  uint8_t longestPayload() const override { return payload; }
  uint16_t airtimeMillis(uint8_t length) const override { return static_cast<uint16_t>((42 + 6 * length) * slower); }
  uint8_t slotMillis() const override { return static_cast<uint8_t>(8 * slower); }
  uint8_t *receive(javinolib::Received &with) override;
  void release() override;
  javinolib::Mender *mender() override { return mends ? &mender_ : nullptr; }
#if JAVINO_LARGE
  uint8_t follow(javinolib::Trailer trailer, uint8_t length) override {
    trailer_ = trailer;
    return javinolib::RadioEncoder::trailerLength(trailer, static_cast<uint8_t>(length + 3));
  }
#endif
  uint8_t *sentPath() override { return mends ? &path_ : nullptr; }
  void counters(javinolib::RadioCounters &into) const override { into = counts; }
  bool idle() const override { return in_.empty(); }

  /// A packet arrives of which these bits are wrong, counted from the first one of its count.
  void arrive(const Bytes &payload, const std::set<size_t> &wrongBits = {},
              javinolib::Trailer trailer = javinolib::Trailer::NONE, uint8_t hops = 0) {
    in_.push_back({packetOf(payload, wrongBits, trailer, hops), trailer, payload});
  }

  /// The packet on the air ends.
  void finishSending();

  std::function<void()> working;  ///< what it does whenever it is asked what has come
  bool works = true;              ///< whether begin() succeeds
  bool refuses = false;           ///< whether send() does nothing
  bool mends = false;             ///< whether packets come as from the air
  bool heard = false;             ///< whether another board's carrier is on the air
  mutable bool wasHeard = false;  ///< whether one was, since the board has looked
  uint8_t slower = 1;             ///< by how many times than an ASK pair, 1…31
  uint8_t payload = javinolib::MAX_RADIO_PAYLOAD;
  javinolib::RadioCounters counts = {};
  std::vector<Bytes> sent;
  std::vector<javinolib::Trailer> trailers;  ///< what followed each of these
  std::vector<uint8_t> behind;               ///< behind each of these

 private:
  struct Arrived {
    javinolib::RadioPacket packet;
    javinolib::Trailer trailer;
    Bytes payload;
  };

  static javinolib::RadioPacket packetOf(const Bytes &payload, const std::set<size_t> &wrongBits,
                                         javinolib::Trailer trailer, uint8_t hops);

  std::deque<Arrived> in_;
  javinolib::Mender mender_;
  javinolib::Trailer trailer_ = javinolib::Trailer::NONE;
  uint8_t path_ = 0;
  bool onAir_ = false;
};
