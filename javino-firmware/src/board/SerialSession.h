#pragma once

#include <stdint.h>

#include "../framing/PacketDecoder.h"
#include "../framing/PacketEncoder.h"
#include "../support/Inlining.h"
#include "Commands.h"
#include "../support/Counters.h"
#include "Reply.h"
#include "SerialPort.h"
#include "../support/Zeroed.h"

namespace javinolib {

/// The board's end of the serial line: one reply to each request, repeats answered from memory (SPEC 4.1, 4.2).
///
/// Nothing waits: a reply goes out as the UART takes it. A request that comes meanwhile takes the place of what is out, and
/// is performed behind it. While a poll is held nothing is read, and a byte that comes ends the hold.
class SerialSession {
 public:
  /// @param bytes of `room` bytes, for packets from the host and to it
  SerialSession(SerialPort port, uint8_t *bytes, Length room, SerialCounters &counters)
      : port_(port), counters_(counters), decoder_(bytes, room), reply_(bytes, room) {}

  /// Reads, has requests performed, and answers as far as bytes and room are there.
  /// @param commands what performs a request, and answers a poll later: perform(request, reply), answer(reply, released)
  template <typename Commands>
  void run(Commands &commands) {
    counters_->longest(Counter::LOOP_MILLIS, ranAt_);
    finish(commands);
    exchange();
    while (mayTake()) {
      Request request;
      if (take(request)) remembers_ = commands.perform(request, reply_);
      finish(commands);
      exchange();
    }
  }

  /// The board goes back to its sketch.
  void ran() { ranAt_ = static_cast<uint16_t>(clock::millis()); }

  /// Has the host ask again: after a boot, in which the reply to a poll that was held is lost, and after damage.
  void askAgain();

  /// Whether run() has nothing to do until the UART's next interrupt.
  bool isIdle() const;

 private:
  template <typename Commands>
  void finish(Commands &commands) {
    if (replyOpen_ && port_.canWrite() && commands.answer(reply_, port_.canRead())) send();
  }
  bool mayRead() const { return !requestWaits_ && port_.canRead() && encoder_.hasGiven(decoder_.next()); }
  bool mayTake() const { return requestWaits_ && encoder_.done() && port_.canWrite(); }
  void exchange();
  void add(PacketEvent event);
  bool take(Request &request);
  void send();
  bool isRepeat(const Request &request) const;

  SerialPort port_;
  Part<SerialCounters> counters_;
  PacketEncoder encoder_;
  uint16_t ranAt_ JAVINO_ZEROED;        // the end of the last run, in the low half of the clock's milliseconds
  bool requestWaits_ JAVINO_ZEROED;     // a whole request is in the decoder
  bool replyOpen_ JAVINO_ZEROED;        // the request was performed, and its reply is not finished: a poll may be held
  bool remembers_ JAVINO_ZEROED;        // a repeat of the request is known
  uint8_t lastSequence_ JAVINO_ZEROED;  // of the request that the reply answers
  uint16_t lastCrc_ JAVINO_ZEROED;
  PacketDecoder decoder_;
  Reply reply_;
};

}  // namespace javinolib
