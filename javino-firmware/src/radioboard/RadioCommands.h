#pragma once

#include <stdint.h>

#include "../delivery/Delivery.h"
#include "../radio/Radio.h"
#include "../secure/BoardState.h"
#include "../board/Commands.h"
#include "../support/Inlining.h"
#include "KeyCommands.h"
#include "News.h"
#include "../support/Part.h"

namespace javinolib {

/// Performs the requests of SPEC 4.3 on a board with a radio: those that every board knows, and those to radio and keys.
class RadioCommands {
 public:
  RadioCommands(Commands &commands, BoardState &state, Delivery &delivery, Poll &poll)
      : commands_(commands),
        state_(state),
        keyCommands_(state.keys, state.replays, state.nonces),
        delivery_(delivery),
        news_(delivery),
        poll_(poll) {}

  /// As Commands::perform().
  template <typename Scope = WholeScope>
  bool perform(const Request &request, Reply &reply);

  /// As Commands::answer(): news come before a reading.
  bool answer(Reply &reply, bool released);

  /// Whether a poll is held to which answer() has news to tell. Safe to call with interrupts off.
  bool canTell() const { return poll_->isHeld() && news_.areWaiting(); }

 private:
  template <typename Scope>
  Status dispatch(const Request &request, Reply &reply);
  template <typename Scope>
  Status transmit(const Request &request, Reply &reply);
  template <typename Scope>
  Status mayTransmit(const Frame &frame) const;
  template <typename Scope>
  Status checkAddresses(const Frame &frame) const;
  template <typename Scope>
  Status command(const Request &request, Reply &reply);
  template <typename Scope>
  Status hello(const Request &request, Reply &reply);
  template <typename Scope>
  void polled(const Request &request);
  template <typename Scope>
  Status keysChanged(Status status);
  Status setRfId(const uint8_t *body, Length length);
  Status openRadio(const uint8_t *body, Length length);
  Status overhear(const uint8_t *body, Length length);
  Status relay(const uint8_t *body, Length length, Reply &reply);
  Status relaying(const uint8_t *body, Length length, Reply &reply);
  Status statistics(Length length, Reply &reply);

  Part<Commands> commands_;
  Part<BoardState> state_;
  KeyCommands keyCommands_;
  Part<Delivery> delivery_;
  News news_;
  Part<Poll> poll_;
};

}  // namespace javinolib
