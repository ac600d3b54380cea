#pragma once

#include <stdint.h>

#include "../delivery/Delivery.h"
#include "../radio/Radio.h"
#include "../secure/BoardState.h"
#include "../support/Inlining.h"
#include "Actions.h"
#include "KeyCommands.h"
#include "Poll.h"
#include "Reply.h"
#include "../support/Zeroed.h"

namespace javinolib {

/// Performs the requests of SPEC 4.3: finds the command, checks its body, and hands it to the part that does it.
class Commands {
 public:
  /// @param firmwareName UTF-8; what exceeds 100 bytes is not told
  Commands(const char *firmwareName, BoardState &state, Delivery &delivery, Poll &poll, Actions &actions)
      : firmwareName_(firmwareName),
        state_(state),
        keyCommands_(state.keys, state.replays, state.nonces),
        delivery_(delivery),
        poll_(poll),
        actions_(actions) {}

  /// Performs a request and writes status and body of its reply, which stands at an OK without a body. The body of a
  /// poll's reply is left to Poll::answer().
  /// @return whether the reply is to be remembered for repeats of the request
  bool perform(const Frame &request, Reply &reply);

  /// Whether the request is always performed, even if it is byte by byte the one before.
  static bool isAlwaysPerformed(const Frame &request);

 private:
  Status dispatch(const Frame &request, Reply &reply);
  JAVINO_NOINLINE Status transmit(const Frame &frame, Reply &reply);
  Status mayTransmit(const Frame &frame) const;
  Status checkAddresses(const Frame &frame) const;
  Status command(char name, const uint8_t *body, uint16_t length, Reply &reply);
  Status hello(const uint8_t *body, uint16_t length, Reply &reply);
  Status poll(const uint8_t *body, uint16_t length);
  JAVINO_NOINLINE Status keysChanged(Status status);
  Status setRfId(const uint8_t *body, uint16_t length);
  Status openRadio(const uint8_t *body, uint16_t length);
  Status overhear(const uint8_t *body, uint16_t length);
  Status relay(const uint8_t *body, uint16_t length, Reply &reply);
  Status relaying(const uint8_t *body, uint16_t length, Reply &reply);
  JAVINO_NOINLINE Status statistics(uint16_t length, Reply &reply);

  const char *const firmwareName_;
  BoardState &state_;
  KeyCommands keyCommands_;
  Delivery &delivery_;
  Poll &poll_;
  Actions &actions_;
  bool greeted_ JAVINO_ZEROED;
};

}  // namespace javinolib
