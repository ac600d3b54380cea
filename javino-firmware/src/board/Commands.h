#pragma once

#include <stdint.h>

#include "../delivery/Delivery.h"
#include "../radio/Radio.h"
#include "../secure/NonceSource.h"
#include "../storage/KeyStore.h"
#include "../storage/RfId.h"
#include "../support/Inlining.h"
#include "Actions.h"
#include "../support/Counters.h"
#include "KeyCommands.h"
#include "Poll.h"
#include "Reply.h"

namespace javino {

/// Performs the requests of SPEC 4.3: finds the command, checks its body, and hands it to the part that does it.
class Commands {
 public:
  /// @param firmwareName UTF-8; what exceeds 100 bytes is not told
  Commands(const char *firmwareName, Radio &radio, RfId &id, const KeyStore &keys, const NonceSource &nonces,
           KeyCommands &keyCommands, Delivery &delivery, Poll &poll, Actions &actions, Counters &counters)
      : firmwareName_(firmwareName),
        radio_(radio),
        id_(id),
        keys_(keys),
        nonces_(nonces),
        keyCommands_(keyCommands),
        delivery_(delivery),
        poll_(poll),
        actions_(actions),
        counters_(counters),
        greeted_(false) {}

  /// Performs a request and writes status and body of its reply, which stands at an OK without a body.
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
  Status poll(const uint8_t *body, uint16_t length, Reply &reply);
  JAVINO_NOINLINE Status keysChanged(Status status);
  Status setRfId(const uint8_t *body, uint16_t length);
  Status openRadio(const uint8_t *body, uint16_t length);
  Status statistics(uint16_t length, Reply &reply);

  const char *const firmwareName_;
  Radio &radio_;
  RfId &id_;
  const KeyStore &keys_;
  const NonceSource &nonces_;
  KeyCommands &keyCommands_;
  Delivery &delivery_;
  Poll &poll_;
  Actions &actions_;
  Counters &counters_;
  bool greeted_;
};

}  // namespace javino
