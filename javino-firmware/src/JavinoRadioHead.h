#pragma once

/// Javino's packets over a radio of RadioHead, whose header a sketch includes too. RadioHead is under GPL v3, or a commercial
/// licence: so is a program of such a sketch. Tried with RadioHead 1.112.
///
///   RH_RF95 rf95(10, 2);
///   JavinoRadioHead radio(rf95, JavinoAirRate::lora(7, 125000, 5));
///   JavinoRadioBoard board(Serial, "lamp 1.0", radio);

#include <RHGenericDriver.h>

#include "support/SketchMacros.inc"

#include "radio/DriverRadio.h"

namespace javinolib {

/// No function waits: send() of a RadioHead driver does so only while it sends, or for a quiet channel where it has a time-out for
/// that, and isChannelActive() always. The path travels in RadioHead's header as id, so that only RadioHead's own radios
/// understand each other.
class RadioHeadRadio : public DriverRadio {
 public:
  /// @param driver any of RadioHead's whose send() returns at once. If the sketch has not called its init(), begin() does, and it
  /// has the settings of RadioHead; all boards in range have the same
  /// @param rate of those settings
  template <typename Driver>
  RadioHeadRadio(Driver &driver, const AirRate &rate)
      : DriverRadio(rate, HEADER), driver_(driver), hears_(earOf<Driver>(0)) {}

  bool begin() override {
    if (driver_.mode() == RHGenericDriver::RHModeInitialising && !driver_.init()) return false;
    driver_.setCADTimeout(0);
    return measure(driver_.maxMessageLength(), hears_ != nullptr);
  }

  bool send(const uint8_t *payload, uint8_t length) override {
    if (!takes(length) || driver_.mode() == RHGenericDriver::RHModeTx) return false;
    driver_.setHeaderId(sentPath_);
    if (!driver_.send(payload, length)) return false;
    begun(length);
    tellsEnd_ = driver_.mode() == RHGenericDriver::RHModeTx;
    return true;
  }

  bool carrier() const override {
    const bool before = heard_;
    heard_ = !sending_ && driver_.mode() == RHGenericDriver::RHModeRx && hears_ && hears_(driver_);
    return before || heard_;
  }

  // available() makes the driver listen again.
  uint8_t *receive(Received &with) override {
    if (sending_) finish();
    if (!waits_ && !sending_ && driver_.available()) take();
    with.length = length_;
    with.path = path_;
    return waits_ ? in_ : nullptr;
  }

  void counters(RadioCounters &into) const override {
    into = counters_;
    into.damaged = static_cast<config::Count>(into.damaged + driver_.rxBad());
  }

 private:
  static const uint8_t HEADER = 4;
  static const uint8_t MODEM_STATUS = 0x18;  // a register of LoRa chips:
  static const uint8_t SIGNAL_HEARD = 0x0B;  // signal detected, synchronized, or header valid
  static const int8_t QUIET_DBM = -90;       // what is stronger is a carrier

  typedef bool (*Ear)(RHGenericDriver &);

  // Other types than dBm are of chips that tell something else.
  static bool isStrong(int8_t dbm) { return dbm > QUIET_DBM; }
  template <typename Other>
  static bool isStrong(Other) = delete;

  // LoRa chips tell of a signal, and an RF69 of its strength; other drivers have no function for that.
  template <typename Driver>
  static auto earOf(int) -> decltype(Driver::Bw125Cr45Sf128, Ear()) {
    return hearsSignal<Driver>;
  }
  template <typename Driver>
  static auto earOf(long) -> decltype(isStrong(static_cast<Driver *>(nullptr)->rssiRead()), Ear()) {
    return hearsStrength<Driver>;
  }
  template <typename Driver>
  static Ear earOf(...) {
    return nullptr;
  }

  template <typename Driver>
  static bool hearsSignal(RHGenericDriver &driver) {
    return (static_cast<Driver &>(driver).spiRead(MODEM_STATUS) & SIGNAL_HEARD) != 0;
  }
  template <typename Driver>
  static bool hearsStrength(RHGenericDriver &driver) {
    return isStrong(static_cast<Driver &>(driver).rssiRead());
  }

  void finish() {
    const bool isOver = tellsEnd_ ? driver_.mode() != RHGenericDriver::RHModeTx : elapsed() >= airtime_;
    if (!isOver && !isOverdue()) return;
    if (!isOver) driver_.setMode(RHGenericDriver::RHModeIdle);
    ended();
  }

  void take() {
    length_ = sizeof in_;
    path_ = driver_.headerId();
    if (!driver_.recv(in_, &length_)) return;
    heard_ = true;
    waits_ = length_ != 0 && length_ <= longestPayload_ && path_ < PATHS;
    countUp(waits_ ? counters_.received : counters_.damaged);
  }

  RHGenericDriver &driver_;
  const Ear hears_;
  bool tellsEnd_ JAVINO_ZEROED;       // the driver, of the packet that it sends
  mutable bool heard_ JAVINO_ZEROED;  // a packet came since carrier() was called, or a carrier was heard then
  uint8_t length_ JAVINO_ZEROED;
  uint8_t path_ JAVINO_ZEROED;
  uint8_t in_[MAX_RADIO_PAYLOAD];
};

}  // namespace javinolib

using JavinoRadioHead = javinolib::RadioHeadRadio;
using JavinoAirRate = javinolib::AirRate;

JAVINO_EACH_NAME(JAVINO_BRING_BACK)
#undef JAVINO_MACROS_ARE_ASIDE
