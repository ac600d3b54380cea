#include "support/Victim.h"

#include <secure/Envelope.h>

#include <algorithm>

#include "support/Digits.h"

static const uint8_t FRAGMENT_LENGTH = 67;
static const uint32_t SENDER_EPOCH = 5;

const Bytes &Victim::pairKey() {
  static const Bytes KEY = fromHex("000102030405060708090a0b0c0d0e0f");
  return KEY;
}

const Bytes &Victim::groupKey() {
  static const Bytes KEY = fromHex("f0e1d2c3b4a5968778695a4b3c2d1e0f");
  return KEY;
}

Victim::Victim(uint32_t seed) : random(seed) {
  board.start("SUPO");
  board.setKey("ROMA", pairKey());
  board.setKey("//SU", groupKey());
}

void Victim::hear(const Bytes &packet) {
  board.receive(packet);
  if (board.radio.sending()) board.finishSending();
}

void Victim::suffer(const Bytes &packet) {
  tally.tries++;
  hear(packet);
}

void Victim::suffer(const Bytes &packet, double wrongBits) {
  std::set<size_t> wrong;
  for (size_t bit = 0; bit < 12 * (packet.size() + 3); bit++) {
    if (random.number(1 << 16) < wrongBits * (1 << 16)) wrong.insert(bit);
  }
  tally.tries++;
  board.radio.arrive(packet, wrong, random.number(4) == 0 ? javinolib::Trailer::PARITY : javinolib::Trailer::NONE);
  board.board->run();
  if (board.radio.sending()) board.finishSending();
}

Bytes Victim::genuine(size_t contentLength, bool toGroup) {
  counter_++;
  const std::string number = std::to_string(counter_);
  std::string content = number + ";";
  while (content.size() < contentLength) content += static_cast<char>('a' + random.number(26));
  const Bytes nonce = {0,
                       0,
                       SENDER_EPOCH,
                       static_cast<uint8_t>(counter_ >> 16),
                       static_cast<uint8_t>(counter_ >> 8),
                       static_cast<uint8_t>(counter_)};
  return sealed(toGroup ? groupKey() : pairKey(), toGroup ? "//SU" : "SUPO", "ROMA", nonce, content);
}

void Victim::allow(const Bytes &frame) {
  Bytes copy = frame;
  javinolib::DerivedKeys keys;
  keys.derive((frame[0] == '/' ? groupKey() : pairKey()).data());
  const uint16_t length = javinolib::Envelope(keys).open(copy.data(), static_cast<uint16_t>(copy.size()));
  const auto start = copy.begin() + javinolib::Envelope::CONTENT_AT;
  allowed_.insert(std::string(start, start + length));
}

void Victim::take() {
  for (;;) {
    const std::vector<PolledMessage> messages = board.messages();
    if (messages.empty()) break;
    for (const PolledMessage &message : messages) tally.accepted += allowed_.erase(message.content) == 0;
    board.pollTaking(messages.back().number);
  }
  board.radio.sent.clear();
}

void Victim::deliver(const Bytes &frame) {
  take();
  allow(frame);
  const size_t before = allowed_.size();
  if (frame.size() <= javinolib::MAX_RADIO_PAYLOAD) {
    hear(frame);
  } else {
    for (const Bytes &packet : fragmentsOf(frame, random.number(64))) hear(packet);
  }
  take();
  tally.genuine++;
  tally.lost += allowed_.size() == before;
}

void Victim::skip(uint32_t millis) {
  board.clock.millis += millis;
  board.board->run();
  if (board.radio.sending()) board.finishSending();
}

void Victim::reset(bool keepsRam) {
  board.eeprom.restorePower();
  if (keepsRam) {
    board.reboot();
  } else {
    board.powerUp();
  }
  board.hello();
  board.request('R', {1});
}

char digit(unsigned value) { return digits()[value % 64]; }

Bytes fragment(const std::string &origin, unsigned id, unsigned index, const Bytes &part) {
  const std::string header =
      origin + digit(static_cast<unsigned>(part.size() * 8 / 64)) + digit(static_cast<unsigned>(part.size() * 8));
  return bytesOf(std::string("+F") + digit(id) + digit(index) + header) + part;
}

std::vector<Bytes> fragmentsOf(const Bytes &frame, unsigned id) {
  const std::string origin(frame.begin() + 4, frame.begin() + 8);
  std::vector<Bytes> fragments;
  for (size_t at = 0; at < frame.size(); at += FRAGMENT_LENGTH) {
    const size_t end = std::min<size_t>(at + FRAGMENT_LENGTH, frame.size());
    fragments.push_back(
        fragment(origin, id, static_cast<unsigned>(fragments.size()), Bytes(frame.begin() + at, frame.begin() + end)));
  }
  return fragments;
}
