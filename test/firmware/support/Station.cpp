#include "Station.h"

#include <stdexcept>

using javinolib::Status;

Station::Station(const std::string &id) : id(id) {
  board.start(id);
  greet();
}

void Station::greet() {
  board.hello();
  board.request('R', {1});
}

void Station::share(Station &other, const Bytes &key) {
  setKey(other.id, key);
  other.setKey(id, key);
}

void Station::setKey(const std::string &address, const Bytes &key) {
  board.use();
  board.setKey(address, key);
}

bool Station::send(const std::string &to, const std::string &content) {
  board.use();
  const BoardReply reply = board.transmit(to, id, content);
  if (reply.status == Status::QUEUE_FULL) return false;
  if (reply.status != Status::OK) throw std::runtime_error("the board refused a message");
  underWay[reply.body.at(0)] = content;
  return true;
}

void Station::step() {
  board.use();
  board.pass(1);
  if (untilPoll_ != 0) untilPoll_--;
  if (awake && untilPoll_ == 0) poll();
}

void Station::poll() {
  untilPoll_ = pollInterval;
  const PollReply reply = handedOn_ == nullptr ? board.poll() : board.pollTaking(*handedOn_);
  if (handedOn_ != nullptr) unconfirmed_.clear();
  handedOn_.reset();
  for (const PollRecord &record : reply.records) {
    if (record.type == 'M') take(PolledMessage(record.value));
    if (record.type != 'T') continue;
    ended[underWay.at(record.value.at(0))] = static_cast<End>(record.value.at(1));
    endedInOrder.push_back(underWay.at(record.value.at(0)));
    underWay.erase(record.value.at(0));
  }
}

void Station::take(const PolledMessage &message) {
  untilPoll_ = 1;
  handedOn_.reset(new uint8_t(message.number));
  const std::string name = message.origin + message.destination + textOf(message.id);
  if (message.destination != "////" && !unconfirmed_.insert(name).second) return;
  received.push_back(message.content);
}

void Station::reset(bool keepsRam) {
  for (const auto &entry : underWay) ended[entry.second] = CUT_OFF;
  underWay.clear();
  handedOn_.reset();
  if (keepsRam) {
    board.reboot();
  } else {
    board.powerUp();
  }
  greet();
}
