#pragma once

#include <stdint.h>

#include "../radio/Radio.h"
#include "../support/Inlining.h"
#include "Fragments.h"
#include "../support/Zeroed.h"

namespace javinolib {

/// Medium access (SPEC 7.4): whether the air is busy, and for how many slots it has been quiet.
class MediumAccess {
 public:
  explicit MediumAccess(Radio &radio) : radio_(radio), slotMillis_(1), sending_(true) {}

  /// Starts the radio; to be called once, after a boot.
  /// @return false where it does not start
  bool begin();

  /// Looks at air and clock; to be called once before each look at what to send.
  void update();

  /// From this number on, slots are counted in a circle: it follows 255.
  static const uint8_t CIRCLE = 128;

  /// Quiet slots since the last carrier, another's or our own: 0…255, and 128…255 again and again. So who counts slots never
  /// comes to an end, and who asks for fewer than 128 need not know. To be read after update().
  uint8_t quietSlots() const { return quietSlots_; }

  /// The number of the slot after the one with this number.
  static uint8_t slotAfter(uint8_t slot) { return static_cast<uint8_t>((slot + 1) | (slot & CIRCLE)); }

  /// Whether another board's carrier is heard, or was since the update() before.
  bool hearsCarrier() const { return carrier_; }

  /// Whether a packet of ours is on the air, or was at the last update().
  bool isSending() const { return sending_; }

  /// Whether either is.
  bool isBusy() const { return carrier_ || sending_; }

  /// Milliseconds of quiet air since the update() before.
  uint8_t quietMillis() const { return quietMillis_; }

  /// Starts to send a packet; the air counts as busy from now on.
  /// @param trailer what follows it
  /// @return false where the radio did not take it
  bool send(const uint8_t *payload, uint8_t length, Trailer trailer = Trailer::NONE);

  /// Starts to send a relay's packet.
  /// @param path as SPEC 6 has it, 0…19
  /// @return false where the radio did not take it
  bool sendCopy(const uint8_t *payload, uint8_t length, uint8_t path, Trailer trailer = Trailer::NONE);

  /// Whether the radio can tell others the path of a packet.
  bool canRelay() { return radio_.sentPath() != nullptr; }

  /// How long a relay's copy of a broadcast or multicast may begin behind its end (SPEC 7.5).
  uint16_t mostCopyMillis() const { return static_cast<uint16_t>(COPY_SLOTS * slotMillis_); }

  /// How long ago the sender of a packet that comes in may have begun it, whether this is a copy or not.
  uint16_t begunMillis(const Received &with) const {
    uint16_t millis = airtimeMillis(with.length);
    if (with.path != 0) millis = static_cast<uint16_t>(millis + mostCopyMillis());
    return millis;
  }

  /// The oldest packet that the radio holds; it belongs to the caller until release().
  /// @param with set where one waits
  /// @return null where none waits
  uint8_t *receive(Received &with) { return radio_.receive(with); }

  /// The mender that knows how that packet came; null where the radio gives intact ones only.
  Mender *mender() { return radio_.mender(); }

  /// Drops that packet, or the one that is lost.
  JAVINO_NOINLINE void release() { radio_.release(); }

  /// Whether the radio holds none. Safe to call with interrupts off.
  bool isIdle() const { return radio_.idle(); }

  /// Copies the radio's counters, and adds the airtime.
  void counters(RadioCounters &into) const {
    radio_.counters(into);
    into.airtime = airtime_;
  }

  /// How long the radio has sent since the boot, in whole seconds.
  config::Count airtime() const { return airtime_; }

  /// How long a packet is on the air.
  /// @param length of its payload, in bytes
  uint16_t airtimeMillis(uint8_t length) const { return radio_.airtimeMillis(length); }

  /// The most bytes that a packet carries beside a header, 16…67.
  uint8_t fragmentLength() const { return fragmentLength_; }

 private:
  static const uint16_t COPY_SLOTS = 256;

  Radio &radio_;
  uint8_t slotMillis_;
  uint8_t fragmentLength_;  // set by begin()
  bool sending_;
  bool carrier_ JAVINO_ZEROED;
  uint8_t quietSlots_ JAVINO_ZEROED;
  uint8_t quietMillis_ JAVINO_ZEROED;
  uint16_t slotSince_ JAVINO_ZEROED;  // when the current quiet slot began
  uint16_t lookedAt_ JAVINO_ZEROED;
  uint16_t airtimeMillis_ JAVINO_ZEROED;  // less than 1000
  config::Count airtime_ JAVINO_ZEROED;   // the seconds before them
};

}  // namespace javinolib
