#pragma once

#include <set>
#include <string>
#include <vector>

#include "Attack.h"
#include "support/TestBoard.h"

/// The board under attack, SUPO, which shares a key with ROMA and one with its group: with its host, with what ROMA
/// genuinely sends, and with the tally.
class Victim {
 public:
  explicit Victim(uint32_t seed);

  RandomBytes random;
  TestBoard board;
  Tally tally;

  /// Hears a packet.
  void hear(const Bytes &packet);

  /// Hears a hostile packet, which counts as a try.
  void suffer(const Bytes &packet);

  /// Hears a hostile packet that comes with wrong bits, each with this chance: what mends looks at it, too.
  void suffer(const Bytes &packet, double wrongBits);

  /// Has an attack go on, turn by turn, until there were this many tries or a few more.
  template <typename Turn>
  const Tally &endure(uint64_t tries, Turn turn) {
    while (tally.tries < tries) turn();
    return tally;
  }

  /// A new sealed frame of ROMA, with a content of this length, to SUPO or its group.
  Bytes genuine(size_t contentLength, bool toGroup);

  /// Has the host take over all that waits. A message that is not allowed, or came before, counts as accepted.
  void take();

  /// Hears a genuine frame, in one packet or in fragments, and takes what came: it is lost where that is not it.
  void deliver(const Bytes &frame);

  /// The content of a frame that is about to be heard may come once, but need not.
  void allow(const Bytes &frame);

  /// Allowed messages that have not come until now must not come any more.
  void disallow() { allowed_.clear(); }

  /// Lets this long pass at once; what the board sends meanwhile is on the air for no time.
  void skip(uint32_t millis);

  /// Resets the board and greets it.
  /// @param keepsRam whether the RAM that a reset leaves alone is still there
  void reset(bool keepsRam);

  /// ROMA's counter goes up by this, as it does above a floor of which it was told.
  void raiseCounter(uint32_t by) { counter_ += by; }

  static const Bytes &pairKey();
  static const Bytes &groupKey();

 private:
  uint32_t counter_ = 0;
  std::set<std::string> allowed_;  // contents
};

/// Base64's digit of a value.
char digit(unsigned value);

/// The fragments of a frame, by SPEC 7.1.
/// @param frame one of 78…521 bytes
/// @param id 0…63
std::vector<Bytes> fragmentsOf(const Bytes &frame, unsigned id);

/// One fragment: `part` goes to `+F`, id and index.
Bytes fragment(const std::string &origin, unsigned id, unsigned index, const Bytes &part);

template <typename T>
void shuffle(std::vector<T> &items, RandomBytes &random) {
  for (size_t left = items.size(); left > 1; left--)
    std::swap(items[left - 1], items[random.number(static_cast<uint32_t>(left))]);
}
