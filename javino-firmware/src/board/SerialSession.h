#pragma once

#include <stdint.h>

#include "../framing/PacketDecoder.h"
#include "../framing/PacketEncoder.h"
#include "../support/Inlining.h"
#include "Commands.h"
#include "../support/Counters.h"
#include "Poll.h"
#include "Reply.h"
#include "SerialPort.h"
#include "../support/Zeroed.h"

namespace javinolib {

/// The board's end of the serial line: one reply to each request, repeats answered from memory (SPEC 4.1, 4.2).
///
/// Nothing waits: a reply goes out as the UART takes it. A request that comes meanwhile stays in the decoder until
/// the reply is out. While a poll is held nothing is read, and a byte that comes ends the hold.
class SerialSession {
 public:
  SerialSession(SerialPort port, Commands &commands, Poll &poll, Counters &counters);

  /// Reads, performs and answers as far as bytes and room are there.
  void run();

  /// Whether run() has nothing to do until the UART's next interrupt.
  bool isIdle() const;

 private:
  void read();
  void take(PacketEvent event);
  JAVINO_NOINLINE void answer();
  void finish();
  bool isRepeat(const Frame &request) const;
  void write();

  SerialPort port_;
  Commands &commands_;
  Poll &poll_;
  Counters &counters_;
  PacketEncoder encoder_;
  bool requestWaits_ JAVINO_ZEROED;     // a whole request is in the decoder
  bool replyOpen_ JAVINO_ZEROED;        // the request was performed, and its reply is not finished: a poll may be held
  bool remembers_ JAVINO_ZEROED;        // the reply can be given again
  uint8_t lastSequence_ JAVINO_ZEROED;  // of the request that the reply answers
  uint16_t lastCrc_ JAVINO_ZEROED;
  PacketDecoder decoder_;
  Reply reply_;
};

}  // namespace javinolib
