#include "TestBoard.h"

#include <secure/Envelope.h>

#include <algorithm>
#include <stdexcept>

#include "Reference.h"

using javinolib::Status;

namespace {

const Bytes EMPTY_PACKET = {1};

// The body of a poll, as SPEC 4.3 defines it.
Bytes pollBody(uint8_t flags, uint16_t holdMillis, uint32_t leastMillis) {
  return {'P',
          flags,
          static_cast<uint8_t>(holdMillis >> 8),
          static_cast<uint8_t>(holdMillis),
          static_cast<uint8_t>(leastMillis >> 16),
          static_cast<uint8_t>(leastMillis >> 8),
          static_cast<uint8_t>(leastMillis)};
}

BoardReply parse(const Bytes &packet, uint8_t sequence) {
  const Bytes inner = reference::cobsDecoded(packet);
  if (inner.size() < 14 || inner[0] != sequence) throw std::runtime_error("not the reply: " + toHex(inner));
  const Bytes checked(inner.begin(), inner.end() - 2);
  if (reference::crc(checked) != (inner[inner.size() - 2] | inner[inner.size() - 1] << 8)) {
    throw std::runtime_error("reply with a wrong CRC: " + toHex(inner));
  }
  const Bytes message(checked.begin() + 11, checked.end());
  if (Bytes(checked.begin() + 1, checked.end()) != reference::frame("++++", "++++", message)) {
    throw std::runtime_error("reply with a wrong header: " + toHex(inner));
  }
  return {static_cast<Status>(message[0]), Bytes(message.begin() + 1, message.end())};
}

PollReply parsePoll(const BoardReply &reply) {
  if (reply.status != Status::OK) throw std::runtime_error("poll failed");
  PollReply parsed;
  parsed.more = (reply.body.at(0) & 1) != 0;
  parsed.leftOut = (reply.body.at(0) & 2) != 0;
  parsed.reading = (reply.body.at(0) & 4) != 0;
  for (size_t i = 1; i < reply.body.size();) {
    const size_t length = static_cast<size_t>(reply.body.at(i + 1) << 8 | reply.body.at(i + 2));
    const Bytes value(reply.body.begin() + i + 3, reply.body.begin() + i + 3 + length);
    parsed.records.push_back({static_cast<char>(reply.body[i]), value});
    i += 3 + length;
  }
  return parsed;
}

}  // namespace

std::vector<std::string> PollReply::texts(char type) const {
  std::vector<std::string> texts;
  for (const PollRecord &record : records) {
    if (record.type == type) texts.push_back(textOf(record.value));
  }
  return texts;
}

PolledMessage::PolledMessage(const Bytes &value)
    : number(value.at(0)),
      destination(value.begin() + 1, value.begin() + 5),
      origin(value.begin() + 5, value.begin() + 9),
      id(value.begin() + 9, value.begin() + 12),
      content(value.begin() + 12, value.end()) {}

void TestBoard::use() {
  clock.use();
  eeprom.use();
  ram.use();
}

bool TestBoard::reboot() {
  use();
  clock.millis = 0;
  port = FakePort();
  const bool mends = radio.mends;
  radio = FakeRadio();
  radio.mends = mends;
  board.reset(new javinolib::RadioBoard(javinolib::SerialPort(port), "test 1.0", other_ == nullptr ? radio : *other_));
  return unicastsOnly ? board->begin<javinolib::UnicastScope>() : board->begin();
}

bool TestBoard::powerUp() {
  ram.losePower();
  return reboot();
}

void TestBoard::start(const std::string &rfId) {
  reboot();
  hello();
  if (!rfId.empty()) request('I', bytesOf(rfId));
  request('R', {1});
  pass(200);
}

BoardReply TestHost::hello() { return request('H', {1}); }

BoardReply TestHost::request(const Bytes &message) { return exchange(reference::frame("++++", "++++", message)); }

BoardReply TestHost::transmit(const std::string &destination, const std::string &origin, const std::string &content) {
  return exchange(plain(destination, origin, content));
}

PollReply TestHost::poll(bool percepts) {
  return parsePoll(request(pollBody(percepts ? PERCEPTS_NOW : NO_PERCEPTS, 0, 0)));
}

PollReply TestHost::pollTaking(uint8_t taken) { return parsePoll(request(pollBody(NO_PERCEPTS, 0, 0) + Bytes{taken})); }

void TestHost::hold(uint8_t flags, uint16_t holdMillis, uint32_t leastMillis) {
  port.arrive(packet(reference::frame("++++", "++++", pollBody(flags, holdMillis, leastMillis))));
  run();
}

bool TestHost::replies() const {
  return std::count(port.written().begin(), port.written().end(), 0) != static_cast<long>(port.written().size());
}

PollReply TestHost::takeReply() {
  const std::vector<Bytes> replies = takePackets();
  if (replies.size() != 1) throw std::runtime_error(std::to_string(replies.size()) + " replies");
  return parsePoll(parse(replies[0], sequence_));
}

std::vector<PolledMessage> TestBoard::messages() {
  std::vector<PolledMessage> messages;
  for (const PollRecord &record : poll().records) {
    if (record.type == 'M') messages.push_back(PolledMessage(record.value));
  }
  return messages;
}

uint32_t TestHost::counter(javinolib::Counter counter) {
  const Bytes body = request('S').body;
  for (size_t i = 0; i + 5 <= body.size(); i += 5) {
    if (body[i] != static_cast<uint8_t>(counter)) continue;
    return static_cast<uint32_t>(body[i + 1]) << 24 | body[i + 2] << 16 | body[i + 3] << 8 | body[i + 4];
  }
  throw std::runtime_error("no such counter");
}

BoardReply TestHost::exchange(const Bytes &frame) {
  std::vector<Bytes> replies = sendRaw(packet(frame));
  const bool isPoll = frame.size() > 10 && frame[0] == '+' && frame[10] == 'P';
  if (replies.empty() && isPoll) replies = sendRaw({0});
  if (replies.size() != 1) throw std::runtime_error(std::to_string(replies.size()) + " replies");
  return parse(replies[0], sequence_);
}

std::vector<Bytes> TestHost::sendRaw(const Bytes &bytes) {
  port.arrive(bytes);
  run();
  return takePackets();
}

Bytes TestHost::packet(const Bytes &frame) { return reference::packet(++sequence_, frame); }

std::vector<Bytes> TestHost::takePackets() {
  std::vector<Bytes> packets;
  Bytes packet;
  for (uint8_t byte : port.takeWritten()) {
    if (byte != 0) {
      packet.push_back(byte);
    } else {
      if (!packet.empty() && packet != EMPTY_PACKET) packets.push_back(packet);
      packet.clear();
    }
  }
  if (!packet.empty()) throw std::runtime_error("the last reply has no end");
  return packets;
}

void TestBoard::receive(const Bytes &payload) {
  radio.arrive(payload);
  run();
}

void TestBoard::finishSending() {
  radio.finishSending();
  run();
}

void TestHost::pass(uint32_t millis) {
  for (; millis != 0; millis--) {
    clock.millis++;
    run();
  }
}

void TestBoard::passSending(uint32_t millis) {
  for (; millis != 0; millis--) {
    pass(1);
    if (radio.sending()) radio.finishSending();
  }
}

const Bytes &TestBoard::nextSent() {
  for (int left = 2000; !radio.sending(); left--) {
    if (left == 0) throw std::runtime_error("nothing is sent");
    pass(1);
  }
  return radio.sent.back();
}

Bytes TestBoard::sendNext() {
  const Bytes packet = nextSent();
  finishSending();
  return packet;
}

Bytes sealed(const Bytes &key, const std::string &destination, const std::string &origin, const Bytes &nonce,
             const std::string &content) {
  javinolib::DerivedKeys keys;
  keys.derive(key.data());
  const std::string before(javinolib::NONCE_LENGTH, 0);
  const std::string behind(javinolib::TAG_LENGTH, 0);
  Bytes frame = plain(destination, origin, before + content + behind);
  javinolib::Envelope(keys).seal(frame.data(), static_cast<uint16_t>(frame.size()), nonce.data());
  return frame;
}

Bytes plain(const std::string &destination, const std::string &origin, const std::string &content) {
  return reference::frame(destination, origin, bytesOf(content));
}
