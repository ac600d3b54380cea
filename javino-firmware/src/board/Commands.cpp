#include "Commands.h"

#include <string.h>

#include "../storage/EepromLayout.h"
#include "../support/BigEndian.h"

namespace javinolib {

namespace {

const char HELLO = 'H';
const uint8_t FIXED_OF_HELLO = 1 + Address::TEXT_LENGTH + 3;
const uint16_t NAME_ROOM = MAX_MESSAGE_LENGTH - 1 - FIXED_OF_HELLO;
const uint16_t MAX_FIRMWARE_NAME = NAME_ROOM < 100 ? NAME_ROOM : 100;
const uint8_t COUNTER_LENGTH = 1 + 4;
const bool ALL_COUNTERS_FIT = 1 + Counters::COUNT * COUNTER_LENGTH <= MAX_MESSAGE_LENGTH;
const uint8_t POLL_LENGTH = 1 + 2 + 3;

bool isForBoard(const Frame &request) { return request.destination.isSerial(); }

}  // namespace

bool Commands::perform(const Frame &request, Reply &reply) {
  const bool allowed = greeted_ || isAlwaysPerformed(request);
  reply.setStatus(allowed ? dispatch(request, reply) : Status::NOT_GREETED);
  return allowed;
}

bool Commands::isAlwaysPerformed(const Frame &request) {
  return isForBoard(request) && request.length != 0 && request.message[0] == HELLO;
}

Status Commands::dispatch(const Frame &request, Reply &reply) {
  if (isAlwaysPerformed(request)) poll_.tellAgain();
  if (!isForBoard(request)) return transmit(request, reply);
  if (!request.origin.isSerial()) return Status::WRONG_ORIGIN;
  if (request.length == 0) return Status::UNKNOWN_COMMAND;
  return command(static_cast<char>(request.message[0]), request.message + 1, static_cast<uint16_t>(request.length - 1),
                 reply);
}

// Puts a frame to an RF address, with the plain content as message, into the outbox.
Status Commands::transmit(const Frame &frame, Reply &reply) {
  const Status status = mayTransmit(frame);
  if (status != Status::OK) return status;
  Outbox &outbox = delivery_.outbox();
  reply.add(frame.destination.isBroadcast() ? outbox.addPlain(frame) : outbox.addUnsealed(frame));
  return Status::OK;
}

// The first that applies, in the order of SPEC 4.4.
Status Commands::mayTransmit(const Frame &frame) const {
  const Status addresses = checkAddresses(frame);
  if (addresses != Status::OK) return addresses;
  const bool sealed = !frame.destination.isBroadcast();
  if (sealed && state_.keys.current(frame.destination) == KeyStore::NO_SLOT) return Status::NO_KEY;
  const uint16_t length = static_cast<uint16_t>(HEADER_LENGTH + (sealed ? SEAL_LENGTH : 0) + frame.length);
  if (frame.length > MAX_CONTENT_LENGTH || !delivery_.carries(length)) return Status::TOO_LONG;
  if (!delivery_.outbox().fits(length)) return Status::QUEUE_FULL;
  return sealed ? state_.nonces.status() : Status::OK;
}

Status Commands::checkAddresses(const Frame &frame) const {
  if (!state_.id.isSet()) return Status::NO_RF_ID;
  if (frame.origin != state_.id.address()) return Status::WRONG_ORIGIN;
  const Address::Class to = frame.destination.classOf();
  const bool canBeSentTo = to == Address::DEVICE || to == Address::MULTICAST || to == Address::BROADCAST;
  return canBeSentTo && frame.destination != state_.id.address() ? Status::OK : Status::BAD_DESTINATION;
}

Status Commands::command(char name, const uint8_t *body, uint16_t length, Reply &reply) {
  switch (name) {
    case HELLO: return hello(body, length, reply);
    case 'P': return poll(body, length);
    case 'A': return actions_.perform(body, length);
    case 'C': return actions_.list(body, length, reply);
    case 'I': return setRfId(body, length);
    case 'R': return openRadio(body, length);
    case 'O': return overhear(body, length);
    case 'Y': return relay(body, length, reply);
    case 'W': return config::RELAY ? relaying(body, length, reply) : Status::UNKNOWN_COMMAND;
    case 'E': return keyCommands_.raiseEpoch(body, length);
    case 'K':
    case 'N':
      if (name == 'N' && !config::KEY_RENEWAL) return Status::UNKNOWN_COMMAND;
      return keysChanged(keyCommands_.store(name == 'N', body, length, reply));
    case 'U': return config::KEY_RENEWAL ? keyCommands_.use(body, length, delivery_) : Status::UNKNOWN_COMMAND;
    case 'F': return config::KEY_RENEWAL ? keysChanged(keyCommands_.finish(body, length)) : Status::UNKNOWN_COMMAND;
    case 'D': return keysChanged(keyCommands_.erase(body, length));
    case 'V':
      return config::SESSION_KEYS ? keyCommands_.setSession(body, length, delivery_, reply) : Status::UNKNOWN_COMMAND;
    case 'L': return keyCommands_.list(length, reply);
    case 'S': return config::STATISTICS ? statistics(length, reply) : Status::UNKNOWN_COMMAND;
    default: return Status::UNKNOWN_COMMAND;
  }
}

Status Commands::hello(const uint8_t *body, uint16_t length, Reply &reply) {
  if (length != 1) return Status::BAD_ARGUMENT;
  greeted_ = body[0] == PROTOCOL_VERSION;
  uint8_t fixed[FIXED_OF_HELLO];
  fixed[0] = PROTOCOL_VERSION;
  state_.id.address().write(fixed + 1);
  writeUint24(fixed + 1 + Address::TEXT_LENGTH, keyCommands_.epoch());
  if (!retained::holds()) state_.count(Counter::MEMORY_DAMAGED);
  reply.add(fixed, sizeof fixed);
  reply.add(reinterpret_cast<const uint8_t *>(firmwareName_),
            static_cast<uint16_t>(strnlen(firmwareName_, MAX_FIRMWARE_NAME)));
  return Status::OK;
}

// The body of the reply is not written here, but when the poll has been held.
Status Commands::poll(const uint8_t *body, uint16_t length) {
  const bool takes = length == POLL_LENGTH + 1;
  if (length != POLL_LENGTH && !takes) return Status::BAD_ARGUMENT;
  const uint16_t holdMillis = static_cast<uint16_t>(body[1] << 8 | body[2]);
  if (!poll_.hold(body[0], holdMillis, readUint24(body + 3))) return Status::BAD_ARGUMENT;
  if (takes) poll_.taken(body[POLL_LENGTH]);
  return Status::OK;
}

// What was sealed with a key that is gone must not be opened, acknowledged or sealed anew with the next one in its place.
Status Commands::keysChanged(Status status) {
  delivery_.keysChanged();
  return status;
}

Status Commands::setRfId(const uint8_t *body, uint16_t length) {
  Address address;
  if (length != Address::TEXT_LENGTH || !Address::parse(body, address) || !address.isDevice()) {
    return Status::BAD_ARGUMENT;
  }
  if (!state_.id.set(address)) return Status::STORE_FAILED;
  delivery_.seed();
  return Status::OK;
}

Status Commands::openRadio(const uint8_t *body, uint16_t length) {
  if (length != 1 || body[0] > 1) return Status::BAD_ARGUMENT;
  delivery_.open(body[0] == 1);
  return Status::OK;
}

Status Commands::overhear(const uint8_t *body, uint16_t length) {
  if (config::OVERHEARD_BYTES == 0) return Status::UNKNOWN_COMMAND;
  if (length != 1 || body[0] > 1) return Status::BAD_ARGUMENT;
  delivery_.overheard().listen(body[0] == 1);
  return Status::OK;
}

// The frame waits for the air as the message of a broadcast from the serial line.
Status Commands::relay(const uint8_t *body, uint16_t length, Reply &reply) {
  if (config::OVERHEARD_BYTES == 0) return Status::UNKNOWN_COMMAND;
  Frame frame;
  if (Frame::parse(body, length, frame) != FrameError::NONE || !frame.origin.isDevice()) return Status::BAD_ARGUMENT;
  if (frame.origin == state_.id.address()) return Status::WRONG_ORIGIN;
  const Address::Class to = frame.destination.classOf();
  if (to == Address::SERIAL_LINE || to == Address::RESERVED) return Status::BAD_DESTINATION;
  if (frame.length > delivery_.pieceLength()) return Status::TOO_LONG;
  Outbox &outbox = delivery_.outbox();
  if (!outbox.fits(static_cast<uint16_t>(HEADER_LENGTH + length))) return Status::QUEUE_FULL;
  reply.add(outbox.addPlain({Address::broadcast(), Address::serialLine(), body, length}));
  return Status::OK;
}

Status Commands::relaying(const uint8_t *body, uint16_t length, Reply &reply) {
  if (!delivery_.canRelay()) return Status::UNKNOWN_COMMAND;
  const bool on = length == 1 + RELAYING_LENGTH && body[0] == 1;
  const bool off = length == 1 && body[0] == 0;
  if (length != 0 && !on && !off) return Status::BAD_ARGUMENT;
  if (length != 0 && !delivery_.relay(on ? body + 1 : nullptr)) return Status::STORE_FAILED;
  reply.add(delivery_.relays() ? 1 : 0);
  return Status::OK;
}

Status Commands::statistics(uint16_t length, Reply &reply) {
  if (length != 0) return Status::BAD_ARGUMENT;
  RadioCounters radio;
  delivery_.radioCounters(radio);
  const uint32_t *nextOfRadio = reinterpret_cast<const uint32_t *>(&radio);  // in the order of their numbers
  for (uint8_t number = 1; number <= Counters::COUNT; number++) {
    const Counter counter = static_cast<Counter>(number);
    const uint32_t value = Counters::isRadios(counter) ? *nextOfRadio++ : state_.counters.value(counter);
    if (ALL_COUNTERS_FIT || value != 0) {
      uint8_t entry[COUNTER_LENGTH] = {number};
      writeUint32(entry + 1, value);
      reply.add(entry, sizeof entry);
    }
  }
  return Status::OK;
}

}  // namespace javinolib
