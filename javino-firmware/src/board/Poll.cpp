#include "Poll.h"

namespace javino {

const uint8_t Poll::MORE_WAITING;
const uint8_t Poll::PERCEPTS_LEFT_OUT;
const uint8_t Poll::AIR_ACTIVE;

void Poll::answer(bool perceptsWanted, bool airActive, Reply &reply) {
  const uint16_t flagsAt = reply.mark();
  reply.add(0);
  addOutcomes(reply);
  uint8_t flags = airActive ? AIR_ACTIVE : 0;
  if (perceptsWanted && !addPercepts(reply)) flags |= PERCEPTS_LEFT_OUT;
  if (!addMessages(reply)) flags |= MORE_WAITING;
  reply.replace(flagsAt, flags);
}

// All of them fit: Outcomes::MAX_UNREPORTED sees to that.
void Poll::addOutcomes(Reply &reply) {
  for (uint8_t number = outcomes_.first(); number != outcomes_.end(); number++) {
    Record record(reply, 'T');
    record.add(number);
    record.add(static_cast<uint8_t>(outcomes_.of(number)));
    record.close();
  }
  outcomes_.markTold();
}

// Returns whether all percepts fitted.
bool Poll::addPercepts(Reply &reply) {
  Percepts percepts(reply, counters_);
  if (source_ != nullptr) source_(percepts);
  return !percepts.leftOut();
}

// Returns whether all messages fitted.
bool Poll::addMessages(Reply &reply) {
  uint8_t number = inbox_.firstNumber();
  for (ByteQueue::Record record = inbox_.first(); record.bytes != nullptr; record = inbox_.after(record)) {
    if (!addMessage(number++, Inbox::read(record), reply)) return false;
  }
  return true;
}

bool Poll::addMessage(uint8_t number, const Inbox::Message &message, Reply &reply) {
  const uint8_t id[] = {message.nonce[2], message.nonce[4], message.nonce[5]};
  Record record(reply, 'M');
  record.add(number);
  record.add(message.addresses, 2 * Address::TEXT_LENGTH);
  record.add(id, sizeof id);
  record.add(message.content, message.length);
  return record.close();
}

}  // namespace javino
