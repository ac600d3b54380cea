#include "Commands.h"

#include <string.h>

#include "../support/BigEndian.h"

namespace javinolib {

namespace {

const uint8_t MAX_FIRMWARE_NAME = 100;

// Commands that only a board with a radio performs.
#define ANY(letter)
#define RADIO(letter) letter,
#define WHOLE_RADIO(letter) letter,
#define COMMAND(name, letter, text, boards, writesEeprom, meaning) boards(letter)
const char RADIOS[] JAVINO_FLASH = {
#include "Commands.def"
    0};
#undef COMMAND
#undef WHOLE_RADIO
#undef RADIO
#undef ANY

bool isRadios(char name) {
  const FlashText *const names = reinterpret_cast<const FlashText *>(RADIOS);
  for (uint8_t i = 0; flashChar(names, i) != 0; i++) {
    if (flashChar(names, i) == name) return true;
  }
  return false;
}

}  // namespace

void Commands::addCounter(uint8_t number, config::Count value, Reply &reply) {
  uint8_t entry[1 + sizeof(uint32_t)] = {number};
  writeUint32(entry + 1, value);
  reply.add(entry, sizeof entry);
}

bool Commands::allows(const Request &request, Reply &reply) const {
  if (greeted_ || request.isHello()) return true;
  reply.setStatus(Status::NOT_GREETED);
  return false;
}

bool Commands::perform(const Request &request, Reply &reply) {
  if (!allows(request, reply)) return false;
  Status status = request.toBoard ? check(request) : Status::NO_RADIO;
  if (status == Status::OK) {
    const char name = static_cast<char>(*request.message());
    if (name == Request::HELLO) {
      Identity none = {};
      none.version = PROTOCOL_VERSION;
      memset(none.id, '+', sizeof none.id);
      status = hello(request, none, reply);
    } else {
      status = name == Request::STATISTICS ? statistics(request.length, reply) : command(request, reply);
    }
    if (status == Status::UNKNOWN_COMMAND && isRadios(name)) status = Status::NO_RADIO;
  }
  reply.setStatus(status);
  return true;
}

Status Commands::check(const Request &request) {
  if (!request.fromHost) return Status::WRONG_ORIGIN;
  return request.length == 0 ? Status::UNKNOWN_COMMAND : Status::OK;
}

Status Commands::command(const Request &request, Reply &reply) {
  const char name = static_cast<char>(*request.message());
  const uint8_t *const body = request.message() + 1;
  const Length length = static_cast<Length>(request.length - 1);
  switch (name) {
    case Request::POLL: return poll(body, length);
    case 'A': return act(body, length, reply);
    case 'C': return actions_->list(body, length, reply);
    default: return Status::UNKNOWN_COMMAND;
  }
}

Status Commands::act(const uint8_t *body, Length length, Reply &reply) {
  const uint16_t began = static_cast<uint16_t>(clock::millis());
  const Status status = actions_->perform(body, length, reply);
  counters_->longest(Counter::ACTION_MILLIS, began);
  return status;
}

Status Commands::hello(const Request &request, const Identity &identity, Reply &reply) {
  poll_->tellAgain();
  // Until it is greeted, a host speaks to a boot loader too, and perhaps at another speed.
  counters_->at(Counter::SERIAL_DAMAGED) = 0;
  if (request.length != 2) return Status::BAD_ARGUMENT;
  greeted_ = request.message()[1] == PROTOCOL_VERSION;
  reply.add(reinterpret_cast<const uint8_t *>(&identity), sizeof identity);
  const uint16_t most = reply.room() < MAX_FIRMWARE_NAME ? reply.room() : MAX_FIRMWARE_NAME;
  reply.add(reinterpret_cast<const uint8_t *>(firmwareName_), static_cast<uint16_t>(strnlen(firmwareName_, most)));
  return Status::OK;
}

// The body of the reply is not written here, but when the poll has been held.
Status Commands::poll(const uint8_t *body, Length length) {
  if (length != Request::POLL_LENGTH && length != Request::POLL_LENGTH + 1) return Status::BAD_ARGUMENT;
  const uint16_t holdMillis = static_cast<uint16_t>(body[1] << 8 | body[2]);
  return poll_->hold(body[0], holdMillis, readUint24(body + 3)) ? Status::OK : Status::BAD_ARGUMENT;
}

Status Commands::statistics(Length length, Reply &reply) const {
  if (length != 1) return Status::BAD_ARGUMENT;
  for (uint8_t number = 1; number < static_cast<uint8_t>(Counter::END); number++) {
    const Counter counter = static_cast<Counter>(number);
    if (SerialCounters::has(counter)) addCounter(number, counters_->value(counter), reply);
  }
  return Status::OK;
}

}  // namespace javinolib
