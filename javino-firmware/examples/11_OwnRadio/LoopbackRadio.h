#pragma once

#include <JavinoBDI.h>
#include <string.h>

/// An example of a driver for another radio than the ASK pair. Its air is the board's memory: two joined drivers receive
/// each other's packets. These are like those of a small module: 32 bytes, 8 of them a millisecond.
class LoopbackRadio : public JavinoRadio {
 public:
  static const uint8_t LONGEST = 32;

  /// Joins two drivers, so that each receives the other's packets.
  void join(LoopbackRadio &other) {
    other_ = &other;
    other.other_ = this;
  }

  bool begin() override { return other_ != nullptr; }

  bool send(const uint8_t *payload, uint8_t length) override {
    if (length_ != 0 || length == 0 || length > LONGEST) return false;
    memcpy(packet_, payload, length);
    length_ = length;
    sentAt_ = millis();
    return true;
  }

  bool sending() const override { return length_ != 0 && millis() - sentAt_ < airtimeMillis(length_); }
  bool carrier() const override { return !sending() && other_->sending(); }

  uint8_t longestPayload() const override { return LONGEST; }
  uint16_t airtimeMillis(uint8_t length) const override { return static_cast<uint16_t>(1 + length / 8); }
  uint8_t slotMillis() const override { return 2; }

  uint8_t *receive(JavinoReceived &with) override {
    if (length_ != 0 && !sending()) finish();
    with.length = receivedLength_;
    with.path = 0;
    return receivedLength_ == 0 ? nullptr : received_;
  }

  void release() override { receivedLength_ = 0; }
  void counters(JavinoRadioCounters &into) const override { into = counters_; }
  bool idle() const override { return length_ == 0 && receivedLength_ == 0; }

 private:
  // The packet on the air has ended.
  void finish() {
    other_->hear(packet_, length_);
    length_ = 0;
    counters_.sent++;
  }

  // Half duplex: who sends hears nothing.
  void hear(const uint8_t *packet, uint8_t length) {
    if (length_ != 0 || receivedLength_ != 0) {
      counters_.missed++;
      return;
    }
    memcpy(received_, packet, length);
    receivedLength_ = length;
    counters_.received++;
  }

  LoopbackRadio *other_ = nullptr;
  uint8_t packet_[LONGEST];
  uint8_t length_ = 0;  // of the packet on the air, 0 where there is none
  uint32_t sentAt_ = 0;
  uint8_t received_[LONGEST];
  uint8_t receivedLength_ = 0;  // 0 where nothing waits
  JavinoRadioCounters counters_ = {};
};
