#pragma once

/// Javino's packets over a chip of RadioLib (MIT licence), 7.7 or newer; tried with 7.7.1.
///
///   SX1262 chip = new Module(10, 2, 3, 9);
///   JavinoRadioLib radio(chip);
///   JavinoRadioBoard board(Serial, "lamp 1.0", radio);
///
/// and in setup(), before board.begin(): chip.begin(433.5), whose result is RADIOLIB_ERR_NONE where it is wired right.

#include <RadioLib.h>
#include <string.h>

#include "support/SketchMacros.inc"

#include "radio/DriverRadio.h"

#if defined(ESP32) || defined(ESP8266)
#define JAVINO_INTERRUPT IRAM_ATTR
#else
#define JAVINO_INTERRUPT
#endif

namespace javinolib {

/// No function waits, but for some bytes of SPI and the millisecond in which a chip changes its mode. With LoRa a short scan of the
/// channel comes before each packet, and a header on the air is a carrier; with FSK what is stronger than -90 dBm. The path is the
/// first byte of a packet.
class RadioLibRadio : public DriverRadio {
 public:
  bool begin() override;
  bool send(const uint8_t *payload, uint8_t length) override;
  bool carrier() const override;
  uint8_t *receive(Received &with) override;

 protected:
  typedef float (*Strength)(PhysicalLayer &);

  RadioLibRadio(PhysicalLayer &chip, const AirRate &rate, Strength strength, void (*interrupt)(),
                volatile bool &happened)
      : DriverRadio(rate, PATH), chip_(chip), strength_(strength), interrupt_(interrupt), happened_(happened) {}

 private:
  static const uint8_t PATH = 1;
  static const uint8_t FSK_PACKET =
      61;  // holds the smallest buffer of a chip, a CC1101's, beside length and two bytes of status
  static constexpr float QUIET_DBM = -90;  // what is stronger is a carrier

  enum State : uint8_t { DEAF, LISTENS, HEARS_HEADER, SCANS, FREE, SENDS };

  void learnRate(uint8_t longest);
  void listen();
  void scan();
  void scanned();
  void take();
  void look();

  PhysicalLayer &chip_;
  const Strength strength_;
  void (*const interrupt_)();
  volatile bool &happened_;   // an interrupt came: the end of what the chip does
  bool scans_ JAVINO_ZEROED;  // it is LoRa
  State state_ JAVINO_ZEROED;
  bool hears_ JAVINO_ZEROED;
  mutable bool heard_ JAVINO_ZEROED;  // since carrier() was called
  uint8_t lookedAt_ JAVINO_ZEROED;
  uint16_t hold_ JAVINO_ZEROED;   // for how long the channel counts as busy after a scan
  uint8_t length_ JAVINO_ZEROED;  // of the packet that waits
  uint8_t in_[PATH + MAX_RADIO_PAYLOAD];
};

// If scans can begin, the modem is LoRa's.
inline bool RadioLibRadio::begin() {
  scans_ = chip_.startChannelScan() == RADIOLIB_ERR_NONE;
  const size_t longest = scans_ ? PATH + MAX_RADIO_PAYLOAD : FSK_PACKET;
  const uint8_t packet = static_cast<uint8_t>(chip_.maxPacketLength < longest ? chip_.maxPacketLength : longest);
  learnRate(packet);
  if (!measure(static_cast<uint8_t>(packet - PATH), scans_ || strength_ != nullptr)) return false;
  listen();
  return state_ != DEAF;
}

// LoRa's packets last for whole groups of symbols: all lengths are asked, for the line above them.
inline void RadioLibRadio::learnRate(uint8_t longest) {
  const uint32_t first = chip_.getTimeOnAir(PATH);
  const uint32_t last = chip_.getTimeOnAir(longest);
  if (last <= first) return;  // the chip cannot tell: it has the rate of the constructor
  const uint32_t byteMicros = (last - first) / static_cast<uint8_t>(longest - PATH) + 1;
  uint32_t most = 0;
  for (uint8_t bytes = PATH; bytes <= longest; bytes++) {
    const uint32_t beside = chip_.getTimeOnAir(bytes) - bytes * byteMicros;
    if (beside <= last && beside > most) most = beside;
  }
  rate_ = AirRate(most, byteMicros);
}

// A send() that comes before the channel was found free begins a scan, and returns false: who wants to send asks again.
inline bool RadioLibRadio::send(const uint8_t *payload, uint8_t length) {
  if (!takes(length) || state_ == DEAF || state_ == SCANS || hears_ || (state_ != FREE && happened_)) return false;
  if (scans_ && state_ != FREE) {
    scan();
    return false;
  }
  uint8_t out[PATH + MAX_RADIO_PAYLOAD] = {sentPath_};
  memcpy(out + PATH, payload, length);
  happened_ = false;
  chip_.setPacketSentAction(interrupt_);
  if (chip_.startTransmit(out, static_cast<size_t>(PATH + length)) != RADIOLIB_ERR_NONE) {
    listen();
    return false;
  }
  state_ = SENDS;
  begun(length);
  return true;
}

inline bool RadioLibRadio::carrier() const {
  const bool before = heard_;
  heard_ = hears_;
  return before || hears_;
}

inline uint8_t *RadioLibRadio::receive(Received &with) {
  switch (state_) {
    case DEAF:
      if (elapsed() >= slotMillis_) listen();
      break;
    case SCANS:
      if (happened_ || elapsed() >= slotMillis_) scanned();
      break;
    case FREE:
      if (elapsed() >= slotMillis_) listen();
      break;
    case SENDS:
      if (!happened_ && !isOverdue()) break;
      chip_.finishTransmit();
      ended();
      listen();
      break;
    case LISTENS:
    case HEARS_HEADER:
      if (happened_) {
        if (!waits_) take();
      } else {
        look();
      }
  }
  with.length = length_;
  with.path = in_[0];
  return waits_ ? in_ + PATH : nullptr;
}

inline void RadioLibRadio::listen() {
  happened_ = false;
  hears_ = false;
  chip_.setPacketReceivedAction(interrupt_);
  state_ = chip_.startReceive() == RADIOLIB_ERR_NONE ? LISTENS : DEAF;
  since_ = now();
}

inline void RadioLibRadio::scan() {
  happened_ = false;
  chip_.setChannelScanAction(interrupt_);
  state_ = SCANS;
  since_ = now();
  if (chip_.startChannelScan() != RADIOLIB_ERR_NONE) listen();
}

// If another is heard, the channel is busy for an acknowledgement's time, or until the end of the packet that comes then.
inline void RadioLibRadio::scanned() {
  const int16_t result = chip_.getChannelScanResult();
  if (result == RADIOLIB_CHANNEL_FREE) {
    state_ = FREE;
    since_ = now();
    return;
  }
  listen();
  hold_ =
      result == RADIOLIB_LORA_DETECTED || result == RADIOLIB_PREAMBLE_DETECTED ? airtimeMillis(MIN_RADIO_PAYLOAD) : 0;
  heard_ = hears_ = hold_ != 0;
}

// The chip is asked once in a millisecond at most.
inline void RadioLibRadio::look() {
  const uint16_t at = now();
  if (static_cast<uint8_t>(at) == lookedAt_) return;
  lookedAt_ = static_cast<uint8_t>(at);
  if (state_ == HEARS_HEADER) {
    if (elapsed() <= airtimeMillis(longestPayload_)) return;
    countUp(counters_.damaged);  // its end was lost, or it is longer than ours
    listen();
  } else if (scans_) {
    if (chip_.checkIrq(RADIOLIB_IRQ_HEADER_VALID) == 1) {
      state_ = HEARS_HEADER;
      since_ = at;
      hears_ = true;
    } else if (elapsed() >= hold_) {
      hold_ = 0;
      hears_ = false;
    }
  } else {
    hears_ = strength_ != nullptr && strength_(chip_) > QUIET_DBM;
  }
  heard_ = heard_ || hears_;
}

inline void RadioLibRadio::take() {
  const size_t length = chip_.getPacketLength();
  const bool fits = length > PATH && length <= static_cast<size_t>(PATH + longestPayload_);
  uint8_t other;
  const int16_t result = chip_.readData(fits ? in_ : &other, fits ? length : 1);
  waits_ = fits && result == RADIOLIB_ERR_NONE && in_[0] < PATHS;
  length_ = static_cast<uint8_t>(length - PATH);
  countUp(waits_ ? counters_.received : counters_.damaged);
  heard_ = true;
  hold_ = 0;
  listen();
}

/// @param number another one for each such radio of a board
template <uint8_t number = 0>
class NumberedRadioLibRadio : public RadioLibRadio {
 public:
  /// @param chip any of RadioLib's, which the sketch begins; all boards in range have the same settings, and check the CRC
  /// @param rate of a chip that does not tell it (RF69, CC1101, Si443x, nRF24); others do
  template <typename Chip>
  explicit NumberedRadioLibRadio(Chip &chip, const AirRate &rate = AirRate(UINT32_MAX / 2, 0))
      : RadioLibRadio(chip, rate, strengthOf<Chip>(0), interrupt, happened()) {}

 private:
  // How chips tell the strength of what they hear now: without starting to receive, not of the last packet.
  template <typename Chip>
  static auto strengthOf(int) -> decltype(static_cast<Chip *>(nullptr)->getRSSI(false, true), Strength()) {
    return [](PhysicalLayer &chip) { return static_cast<Chip &>(chip).getRSSI(false, true); };
  }
  template <typename Chip>
  static auto strengthOf(long) -> decltype(static_cast<Chip *>(nullptr)->getRSSI(false), Strength()) {
    return [](PhysicalLayer &chip) { return static_cast<Chip &>(chip).getRSSI(false); };
  }
  template <typename Chip>
  static Strength strengthOf(...) {
    return ofRf69(static_cast<Chip *>(nullptr));
  }

#if !RADIOLIB_EXCLUDE_RF69
  static Strength ofRf69(const RF69 *) {
    return [](PhysicalLayer &chip) { return chip.getRSSI(); };
  }
#endif
  static Strength ofRf69(const void *) { return nullptr; }

  static volatile bool &happened() {
    static volatile bool happened = false;
    return happened;
  }

  static void JAVINO_INTERRUPT interrupt() { happened() = true; }
};

}  // namespace javinolib

using JavinoRadioLib = javinolib::NumberedRadioLibRadio<>;
using JavinoAirRate = javinolib::AirRate;

JAVINO_EACH_NAME(JAVINO_BRING_BACK)
#undef JAVINO_MACROS_ARE_ASIDE
