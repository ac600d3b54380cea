#include "TestMega.h"

#include <algorithm>
#include <stdexcept>

namespace {

template <size_t room>
void copy(const Bytes &from, uint8_t (&to)[room]) {
  if (from.size() > room) throw std::invalid_argument("too long for the mailbox: " + toHex(from));
  std::copy(from.begin(), from.end(), to);
}

}  // namespace

Mega &mega() {
  static Mega shared(PROGRAM);
  return shared;
}

Outcome perform(Mailbox::Operation operation, const Bytes &key, const Bytes &second, const Bytes &data,
                const Bytes &nonce) {
  Outcome outcome = {};
  copy(key, outcome.mailbox.key);
  copy(second, outcome.mailbox.second);
  copy(nonce, outcome.mailbox.nonce);
  copy(data, outcome.mailbox.bytes);
  outcome.mailbox.length = static_cast<uint16_t>(data.size());
  outcome.cycles = mega().perform(operation, outcome.mailbox);
  return outcome;
}

Outcome answer(const Bytes &line, uint8_t measured) {
  Outcome outcome = {};
  outcome.mailbox.measured = measured;
  copy(line, outcome.mailbox.bytes);
  outcome.mailbox.length = static_cast<uint16_t>(line.size());
  outcome.cycles = mega().perform(Mailbox::ANSWER, outcome.mailbox);
  return outcome;
}
