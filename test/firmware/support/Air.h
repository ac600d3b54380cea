#pragma once

#include <functional>
#include <map>
#include <set>
#include <vector>

#include "Station.h"

/// One air for several stations at 2000 bit/s, in steps of a millisecond. Packets take their time; who sends hears
/// nothing; packets that overlap are lost to all who are in range of both; others are lost to each receiver by chance.
class Air {
 public:
  explicit Air(uint32_t seed) : random(seed) {}

  void join(Station &station) { stations_.push_back(&station); }

  /// A station is out of range of all others, or is back.
  void leave(Station &station, bool away);

  /// Lets a millisecond pass.
  void step();
  void pass(uint32_t millis);

  /// Lets time pass until no station has anything under way or to be polled.
  /// @return whether that came within so many milliseconds
  bool settle(uint32_t millis);

  /// How many of a station's multicasts in one packet have reached another one in none of their copies.
  long missed(const Station &from, const Station &at) const;

  /// A packet that no station sends: an attacker's, whom all hear. It begins at once, whoever else sends.
  void inject(const Bytes &packet, uint8_t hops = 0);

  /// Called with each packet that begins, and whether a station sends it.
  std::function<void(const Bytes &packet)> onPacket;

  RandomBytes random;
  uint32_t lostInThousand = 0;  ///< packets that a receiver loses by chance
  bool hearsCarriers = true;

  /// Whether the one is in range of the other; at first all are.
  std::function<bool(const Station &one, const Station &other)> inRange;

 private:
  struct Packet {
    Station *from;  // null for an attacker's
    Bytes payload;
    uint32_t begin;
    uint32_t end;
    uint8_t hops;
    std::vector<Station *> others;  // that have sent meanwhile; null for an attacker
  };

  void start(Station *from, const Bytes &payload, uint8_t hops);
  bool reaches(const Station *from, const Station &station) const;
  void finish(const Packet &packet);
  void listen(Station &station);

  std::vector<Station *> stations_;
  std::set<const Station *> away_;
  std::map<Bytes, std::set<const Station *>> reached_;  // by each multicast
  std::vector<Packet> onAir_;
  uint32_t now_ = 0;
};
