#include "Poll.h"

namespace javino {

const uint8_t Poll::MORE_WAITING;
const uint8_t Poll::PERCEPTS_LEFT_OUT;

static const uint8_t SENT = 0;

void Poll::answer(bool perceptsWanted, Reply &reply) {
  const uint16_t flagsAt = reply.mark();
  reply.add(0);
  addOutcomes(reply);
  uint8_t flags = 0;
  if (perceptsWanted && !addPercepts(reply)) flags |= PERCEPTS_LEFT_OUT;
  if (!addMessages(reply)) flags |= MORE_WAITING;
  reply.replace(flagsAt, flags);
}

// All of them fit: Transmitter::MAX_UNREPORTED sees to that.
void Poll::addOutcomes(Reply &reply) {
  while (transmitter_.hasOutcome()) {
    Record record(reply, 'T');
    record.add(transmitter_.takeOutcome());
    record.add(SENT);
    record.close();
  }
}

// Returns whether all percepts fitted.
bool Poll::addPercepts(Reply &reply) {
  Percepts percepts(reply, counters_);
  if (source_ != nullptr) source_(percepts);
  return !percepts.leftOut();
}

// Returns whether all messages fitted.
bool Poll::addMessages(Reply &reply) {
  for (uint8_t i = 0; i < received_.count(); i++) {
    if (!addMessage(i, reply)) return false;
  }
  return true;
}

bool Poll::addMessage(uint8_t index, Reply &reply) {
  const ReceivedMessage &message = received_.message(index);
  uint8_t addresses[2 * Address::TEXT_LENGTH];
  message.destination.write(addresses);
  message.origin.write(addresses + Address::TEXT_LENGTH);
  Record record(reply, 'M');
  record.add(received_.numberOf(index));
  record.add(addresses, sizeof addresses);
  record.add(message.content, message.length);
  return record.close();
}

}  // namespace javino
