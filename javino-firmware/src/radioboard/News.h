#pragma once

#include <stdint.h>

#include "../board/Reply.h"
#include "../delivery/Delivery.h"
#include "../support/Inlining.h"
#include "../support/Part.h"

namespace javinolib {

/// News from air and transmissions for a poll, as records (SPEC 4.3): outcomes, received messages, frames without a key,
/// packets that were overheard.
class News {
 public:
  explicit News(Delivery &delivery) : delivery_(delivery), inbox_(delivery.inbox()), captured_(delivery.overheard()) {}

  /// Whether there are any to be told. Safe to call with interrupts off.
  bool areWaiting() const;

  /// Writes the body of a poll's reply: what fits.
  void write(Reply &reply);

  /// The host may not have had the last reply: what that told is told again.
  void tellAgain();

  /// The host has had what the last reply told.
  void forgetTold();

 private:
  void addOutcomes(Reply &reply);
  bool addMessages(Reply &reply);
  bool addNoKeys(Reply &reply);
  bool addOverheard(Reply &reply);
  static bool addMessage(uint8_t number, const Inbox::Message &message, Reply &reply);

  Part<Delivery> delivery_;
  Part<Inbox> inbox_;
  Part<CapturedPackets> captured_;
};

}  // namespace javinolib
