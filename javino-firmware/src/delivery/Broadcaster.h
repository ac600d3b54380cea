#pragma once

#include <stddef.h>
#include <stdint.h>

#include "../framing/Address.h"
#include "../framing/Frame.h"
#include "../framing/Limits.h"
#include "../radio/Radio.h"
#include "../support/Random.h"
#include "Backoff.h"
#include "BroadcastMemory.h"
#include "MediumAccess.h"
#include "../support/Zeroed.h"

namespace javinolib {

/// A board without an agent: it sends and receives short plain broadcasts, in the form that all boards understand
/// (SPEC 2, 6), and waits for quiet air as they do (SPEC 7.4). It needs neither a host nor the EEPROM.
/// On an AVR a global or static object (support/Zeroed.h).
class Broadcaster {
 public:
  static void *operator new(size_t) = delete;

  /// The most bytes of a text: what fits one packet; fewer where the radio carries fewer.
  static const uint8_t MAX_TEXT = FRAGMENT_LENGTH;

  /// A sketch's function that is called for each broadcast of another board.
  /// @param from the sender's address, four digits and a zero
  /// @param text the text of the broadcast, ended by a zero
  typedef void (*Hearer)(const char *from, const char *text);

  // The radio outlives the broadcaster.
  explicit Broadcaster(Radio &radio) : medium_(radio) {}

  // Sets the function that is called for each broadcast of another board.
  void onHeard(Hearer hearer) { hearer_ = hearer; }

  // Starts the radio; call it once, in setup(). The address is this board's own, and no other board in range has it:
  // four letters or digits such as "ROMA". Returns false if it is no address, or if the radio does not start.
  bool begin(const char *address);

  // Sends a text of 1…67 bytes as soon as the air is free. Returns false, and sends nothing, if it has another length,
  // or if the last text still waits for the air.
  bool send(const char *text);

  // Whether a text waits for the air.
  bool isBusy() const { return length_ != 0; }

  // Does all work that is due; call it from loop(), and at least every 5 ms.
  void run();

  // The number of packets since the boot that were no broadcast of another board, or a repeat of one.
  uint32_t ignored() const { return ignored_; }

 private:
  void hear(const uint8_t *packet, const Received &with);
  bool isNew(const Frame &frame, const uint8_t *packet, const Received &with);

  MediumAccess medium_;
  Backoff backoff_;
  Random random_;
  BroadcastMemory heard_;
  Hearer hearer_ JAVINO_ZEROED;
  Address address_;
  uint8_t length_ JAVINO_ZEROED;  // of the frame that waits, 0 where none does
  uint8_t frame_[MAX_RADIO_PAYLOAD];
  uint32_t ignored_ JAVINO_ZEROED;
};

}  // namespace javinolib
