#include "News.h"

#include "../support/Trace.h"

#include "../board/Poll.h"

namespace javinolib {

bool News::areWaiting() const {
  return delivery_->outbox().outcomes().arePending() || inbox_->first().bytes != nullptr ||
         inbox_->unknownKeys().arePending() || captured_->arePending();
}

void News::write(Reply &reply) {
  const Length flagsAt = reply.mark();
  reply.add(0);
  addOutcomes(reply);
  if (!addMessages(reply) || !addNoKeys(reply) || !addOverheard(reply)) reply.replace(flagsAt, Poll::MORE_WAITING);
}

void News::tellAgain() {
  delivery_->outbox().outcomes().keepTold();
  inbox_->unknownKeys().keepTold();
  captured_->keepTold();
}

void News::forgetTold() {
  delivery_->outbox().outcomes().forgetTold();
  inbox_->unknownKeys().forgetTold();
  captured_->forgetTold();
}

// All of them fit: Outcomes::MAX_UNREPORTED sees to that.
void News::addOutcomes(Reply &reply) {
  while (delivery_->outbox().outcomes().arePending()) {
    const TransmissionEnd &end = delivery_->outbox().outcomes().tell();
    Record record(reply, 'T');
    record.add(end.number);
    record.add(static_cast<uint8_t>(end.outcome));
    record.close();
  }
}

// Returns whether all messages fitted.
bool News::addMessages(Reply &reply) {
  uint8_t number = inbox_->firstNumber();
  for (ByteQueue::Record record = inbox_->first(); record.bytes != nullptr; record = inbox_->after(record)) {
    if (!addMessage(number++, Inbox::read(record), reply)) return false;
  }
  return true;
}

// Returns whether all fitted.
bool News::addNoKeys(Reply &reply) {
  while (inbox_->unknownKeys().arePending()) {
    const KeylessFrame &frame = inbox_->unknownKeys().next();
    uint8_t addresses[2 * Address::TEXT_LENGTH];
    frame.destination.write(addresses);
    frame.origin.write(addresses + Address::TEXT_LENGTH);
    Record record(reply, 'N');
    record.add(addresses, sizeof addresses);
    if (!record.close()) return false;
    inbox_->unknownKeys().tell();
  }
  return true;
}

// Returns whether all packets fitted.
bool News::addOverheard(Reply &reply) {
  for (ByteQueue::Record packet = captured_->firstPending(); packet.bytes != nullptr;
       packet = captured_->after(packet)) {
    Record record(reply, 'O');
    record.add(packet.bytes, packet.length);
    if (!record.close()) return false;
    captured_->tell();
  }
  return true;
}

bool News::addMessage(uint8_t number, const Inbox::Message &message, Reply &reply) {
  const uint8_t id[] = {message.nonce[2], message.nonce[4], message.nonce[5]};
  Record record(reply, 'M');
  record.add(number);
  record.add(message.addresses, 2 * Address::TEXT_LENGTH);
  record.add(id, sizeof id);
  record.add(message.content, message.length);
  const bool fitted = record.close();
  if (fitted) trace::tell(trace::HANDED, number);
  return fitted;
}

}  // namespace javinolib
