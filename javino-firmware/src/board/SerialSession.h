#pragma once

#include <stdint.h>

#include "../framing/CobsEncoder.h"
#include "../framing/PacketDecoder.h"
#include "../support/Inlining.h"
#include "Commands.h"
#include "../support/Counters.h"
#include "Reply.h"
#include "SerialPort.h"

namespace javino {

/// The board's end of the serial line: one reply to each request, repeats answered from memory (SPEC 4.1, 4.2).
///
/// Nothing waits: a reply goes out as the UART takes it. A request that comes meanwhile stays in the decoder until
/// the reply is out.
class SerialSession {
 public:
  SerialSession(SerialPort port, Commands &commands, Counters &counters);

  /// Reads, performs and answers as far as bytes and room are there.
  void run();

  /// Whether run() has nothing to do until the UART's next interrupt.
  bool isIdle() const;

 private:
  void read();
  void take(PacketEvent event);
  JAVINO_NOINLINE void answer();
  bool isRepeat(const Frame &request) const;
  void write();

  SerialPort port_;
  Commands &commands_;
  Counters &counters_;
  CobsEncoder encoder_;
  bool requestWaits_;     // a whole request is in the decoder
  bool remembers_;        // the reply can be given again
  uint8_t lastSequence_;  // of the request that the reply answers
  uint16_t lastCrc_;
  PacketDecoder decoder_;
  Reply reply_;
};

}  // namespace javino
