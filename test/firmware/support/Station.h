#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "TestBoard.h"

/// A board on an Air and the host that drives it as SPEC 4.3 says: polls, hands messages on, and polls at once to say that
/// it has. Messages are told apart by their contents, which each test makes different.
class Station {
 public:
  /// How a unicast has ended, for its host.
  enum End { SENT = 0, DELIVERED = 1, UNDELIVERED = 2, CUT_OFF = 3 /* the board was reset meanwhile */ };

  explicit Station(const std::string &id);

  /// Gives both boards a key for each other.
  void share(Station &other, const Bytes &key);
  void setKey(const std::string &address, const Bytes &key);

  /// Asks the board to send.
  bool send(const std::string &to, const std::string &content);

  /// One millisecond: the board runs, and the host, where it is awake and it is time to, polls.
  void step();

  /// Resets the board; the RAM that a reset leaves alone is kept or lost. The host greets it anew.
  void reset(bool keepsRam);

  /// Whether the host polls.
  bool awake = true;
  uint32_t pollInterval = 20;

  const std::string id;
  TestBoard board;
  std::vector<std::string> received;  ///< contents that the host has handed on
  std::map<std::string, End> ended;   ///< by content
  std::vector<std::string> endedInOrder;
  std::map<uint8_t, std::string> underWay;

 private:
  void poll();
  void take(const PolledMessage &message);
  void greet();

  uint32_t untilPoll_ = 0;
  std::unique_ptr<uint8_t> handedOn_;  // the number of the last message that the board was not told of yet
  std::set<std::string> unconfirmed_;  // origins and ids of messages that the board may give once more
};
