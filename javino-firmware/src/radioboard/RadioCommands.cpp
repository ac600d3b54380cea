#include "RadioCommands.h"

#include "../radio/AskHardware.h"
#include "../storage/EepromLayout.h"
#include "../support/BigEndian.h"

namespace javinolib {

namespace {

const bool ALL_COUNTERS_FIT = 1 + Counters::COUNT * 5 <= MAX_MESSAGE_LENGTH;
const uint8_t FLAGS_AT = 1 + HEADER_LENGTH + 1;  // of a poll's reply, in its packet behind the status

}  // namespace

// This is for a board without ASK hardware; otherwise the linker takes that hardware's in its place.
__attribute__((weak)) uint8_t askhardware::takenTimer() { return 0; }

template <typename Scope>
bool RadioCommands::perform(const Request &request, Reply &reply) {
  if (!commands_->allows(request, reply)) return false;
  reply.setStatus(dispatch<Scope>(request, reply));
  return true;
}

template <typename Scope>
Status RadioCommands::dispatch(const Request &request, Reply &reply) {
  if (!request.toBoard) return transmit<Scope>(request, reply);
  const Status status = Commands::check(request);
  return status == Status::OK ? command<Scope>(request, reply) : status;
}

bool RadioCommands::answer(Reply &reply, bool released) {
  if (!poll_->isHeld()) return true;
  if (news_.areWaiting()) {
    news_.write(reply);
    poll_->end();
  } else if (!poll_->answer(reply, released)) {
    return false;
  }
  uint8_t flags = askhardware::takenTimer();
  if (state_->counters->value(Counter::MEMORY_DAMAGED) != 0) flags |= Poll::MEMORY_DAMAGED;
  reply.packet()[FLAGS_AT] |= flags;
  return true;
}

// Puts a frame to an RF address, with the plain content as message, into the outbox.
template <typename Scope>
Status RadioCommands::transmit(const Request &request, Reply &reply) {
  Frame frame;
  Frame::parseHeader(request.frame, frame);  // an origin that is no device is not the board's either
  const Status status = mayTransmit<Scope>(frame);
  if (status != Status::OK) return status;
  Outbox &outbox = delivery_->outbox();
  reply.add(Scope::MANY && frame.destination.isBroadcast() ? outbox.addPlain(frame) : outbox.addUnsealed(frame));
  return Status::OK;
}

// The first that applies, in the order of SPEC 4.4.
template <typename Scope>
Status RadioCommands::mayTransmit(const Frame &frame) const {
  const Status addresses = checkAddresses<Scope>(frame);
  if (addresses != Status::OK) return addresses;
  const bool sealed = !Scope::MANY || !frame.destination.isBroadcast();
  if (sealed && state_->keys.current(frame.destination) == KeyStore::NO_SLOT) return Status::NO_KEY;
  const Length length = static_cast<Length>(HEADER_LENGTH + (sealed ? SEAL_LENGTH : 0) + frame.length);
  if (frame.length > MAX_CONTENT_LENGTH || !delivery_->carries(length)) return Status::TOO_LONG;
  if (!delivery_->outbox().fits(length)) return Status::QUEUE_FULL;
  return sealed ? state_->nonces.status() : Status::OK;
}

template <typename Scope>
Status RadioCommands::checkAddresses(const Frame &frame) const {
  if (!state_->id.isSet()) return Status::NO_RF_ID;
  if (frame.origin != state_->id.address()) return Status::WRONG_ORIGIN;
  const Address::Kind to = frame.destination.kind();
  const bool isToMany = to == Address::MULTICAST || to == Address::BROADCAST;
  if (!Scope::MANY && isToMany) return Status::UNICASTS_ONLY;
  const bool canBeSentTo = to == Address::DEVICE || isToMany;
  return canBeSentTo && frame.destination != state_->id.address() ? Status::OK : Status::BAD_DESTINATION;
}

template <typename Scope>
Status RadioCommands::command(const Request &request, Reply &reply) {
  const char name = static_cast<char>(*request.message());
  const uint8_t *const body = request.message() + 1;
  const Length length = static_cast<Length>(request.length - 1);
  switch (name) {
    case 'I': return setRfId(body, length);
    case 'R': return openRadio(body, length);
    case 'O': return overhear(body, length);
    case 'Y': return Scope::MANY ? relay(body, length, reply) : Status::UNICASTS_ONLY;
    case 'W': return config::LARGE ? relaying(body, length, reply) : Status::UNKNOWN_COMMAND;
    case 'E': return delivery_->outbox().count() != 0 ? Status::BUSY : keyCommands_.raiseEpoch(body, length);
    case 'K':
    case 'N':
      if (!Scope::RENEWS && name == 'N') return Status::UNICASTS_ONLY;
      return keysChanged<Scope>(keyCommands_.store<Scope>(Scope::RENEWS && name == 'N', body, length, reply));
    case KeyCommands::USE:
    case KeyCommands::FINISH:
    case KeyCommands::DELETE: {
      if (!Scope::RENEWS && name != KeyCommands::DELETE) return Status::UNICASTS_ONLY;
      const Status status = keyCommands_.change<Scope>(static_cast<KeyCommands::Change>(name), body, length, delivery_);
      return name == KeyCommands::USE ? status : keysChanged<Scope>(status);
    }
    case 'V':
      return config::SESSION_KEYS ? keyCommands_.setSession<Scope>(body, length, delivery_, reply)
                                  : Status::UNKNOWN_COMMAND;
    case 'L': return keyCommands_.list<Scope>(length, reply);
    case Request::STATISTICS: return statistics(length, reply);
    case Request::HELLO: return hello<Scope>(request, reply);
    default: {
      const Status status = commands_->command(request, reply);
      if (name == Request::POLL && status == Status::OK) polled<Scope>(request);
      return status;
    }
  }
}

template <typename Scope>
Status RadioCommands::hello(const Request &request, Reply &reply) {
  news_.tellAgain();
  if (!retained::holds()) state_->count(Counter::MEMORY_DAMAGED);
  const uint8_t lacks = Scope::MANY ? 0 : Capability::UNICASTS_ONLY;
  Identity identity = {PROTOCOL_VERSION, {}, {}, Capability::RADIO | Capability::MEMORY | lacks};
  writeUint24(identity.bootEpoch, keyCommands_.epoch());
  state_->id.address().write(identity.id);
  return commands_->hello(request, identity, reply);
}

template <typename Scope>
void RadioCommands::polled(const Request &request) {
  const uint8_t *const body = request.message() + 1;
  if ((body[0] & Poll::REPLY_LOST) != 0) {
    news_.tellAgain();
  } else if ((body[0] & Poll::REPLY_COMING) == 0) {
    news_.forgetTold();
  }
  if (request.length > 1 + Request::POLL_LENGTH) delivery_->inbox().taken<Scope>(body[Request::POLL_LENGTH]);
}

// A message sealed with a key that is gone must not be opened, acknowledged or sealed anew with the next one in its place.
template <typename Scope>
Status RadioCommands::keysChanged(Status status) {
  delivery_->keysChanged<Scope>();
  return status;
}

Status RadioCommands::setRfId(const uint8_t *body, Length length) {
  Address address;
  if (length != Address::TEXT_LENGTH || !Address::parse(body, address) || !address.isDevice()) {
    return Status::BAD_ARGUMENT;
  }
  if (!state_->id.set(address)) return Status::STORE_FAILED;
  delivery_->seed();
  return Status::OK;
}

Status RadioCommands::openRadio(const uint8_t *body, Length length) {
  if (length != 1 || body[0] > 1) return Status::BAD_ARGUMENT;
  delivery_->open(body[0] == 1);
  return Status::OK;
}

Status RadioCommands::overhear(const uint8_t *body, Length length) {
  if (!config::LARGE) return Status::UNKNOWN_COMMAND;
  if (length != 1 || body[0] > 1) return Status::BAD_ARGUMENT;
  delivery_->overheard().listen(body[0] == 1);
  return Status::OK;
}

// The frame waits for the air as the message of a broadcast from the serial line.
Status RadioCommands::relay(const uint8_t *body, Length length, Reply &reply) {
  if (!config::LARGE) return Status::UNKNOWN_COMMAND;
  Frame frame;
  if (Frame::parse(body, length, frame) != FrameError::NONE || !frame.origin.isDevice()) return Status::BAD_ARGUMENT;
  if (frame.origin == state_->id.address()) return Status::WRONG_ORIGIN;
  const Address::Kind to = frame.destination.kind();
  if (to == Address::SERIAL_LINE || to == Address::RESERVED) return Status::BAD_DESTINATION;
  if (frame.length > delivery_->fragmentLength()) return Status::TOO_LONG;
  Outbox &outbox = delivery_->outbox();
  if (!outbox.fits(static_cast<Length>(HEADER_LENGTH + length))) return Status::QUEUE_FULL;
  reply.add(outbox.addPlain({Address::broadcast(), Address::serialLine(), body, length}));
  return Status::OK;
}

Status RadioCommands::relaying(const uint8_t *body, Length length, Reply &reply) {
  if (!delivery_->canRelay()) return Status::UNKNOWN_COMMAND;
  const bool on = length == 1 + RELAYING_LENGTH && body[0] == 1;
  const bool off = length == 1 && body[0] == 0;
  if (length != 0 && !on && !off) return Status::BAD_ARGUMENT;
  if (length != 0 && !delivery_->relay(on ? body + 1 : nullptr)) return Status::STORE_FAILED;
  reply.add(delivery_->relays() ? 1 : 0);
  return Status::OK;
}

Status RadioCommands::statistics(Length length, Reply &reply) {
  if (length != 0) return Status::BAD_ARGUMENT;
  RadioCounters radio;
  delivery_->radioCounters(radio);
  const config::Count *ofRadio = reinterpret_cast<const config::Count *>(&radio + 1);  // in the order of their numbers
  for (uint8_t number = Counters::COUNT; number != 0; number--) {  // the last first: others can be left out
    const Counter counter = static_cast<Counter>(number);
    const config::Count value = Counters::isRadios(counter) ? *--ofRadio : state_->counters->value(counter);
    if (ALL_COUNTERS_FIT || value != 0) Commands::addCounter(number, value, reply);
  }
  return Status::OK;
}

template bool RadioCommands::perform<WholeScope>(const Request &, Reply &);
template bool RadioCommands::perform<UnicastScope>(const Request &, Reply &);

}  // namespace javinolib
