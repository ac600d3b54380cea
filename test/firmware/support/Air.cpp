#include "Air.h"

#include <algorithm>

static const uint32_t MILLIS_TO_CARRIER = 6;

static bool isMulticast(const Bytes &packet) {
  const std::string to = textOf(packet).substr(0, 4);
  return to.compare(0, 2, "//") == 0 && to != "////";
}

void Air::step() {
  now_++;
  for (size_t i = 0; i < onAir_.size();) {
    if (onAir_[i].end != now_) {
      i++;
      continue;
    }
    const Packet packet = onAir_[i];
    onAir_.erase(onAir_.begin() + static_cast<long>(i));
    finish(packet);
  }
  for (Station *station : stations_) {
    listen(*station);
    station->step();
    std::vector<Bytes> &sent = station->board.radio.sent;
    if (!sent.empty()) start(station, sent.back(), station->board.radio.behind.back());
    sent.clear();
    station->board.radio.behind.clear();
  }
}

void Air::pass(uint32_t millis) {
  for (; millis != 0; millis--) step();
}

void Air::leave(Station &station, bool away) {
  if (away) {
    away_.insert(&station);
  } else {
    away_.erase(&station);
  }
}

bool Air::settle(uint32_t millis) {
  for (; millis != 0; millis--) {
    step();
    const bool busy = std::any_of(stations_.begin(), stations_.end(), [](Station *s) { return !s->underWay.empty(); });
    if (!busy && onAir_.empty()) {
      pass(500);
      return true;
    }
  }
  return false;
}

void Air::inject(const Bytes &packet, uint8_t hops) { start(nullptr, packet, hops); }

bool Air::reaches(const Station *from, const Station &station) const {
  return from == nullptr || !inRange || inRange(*from, station);
}

void Air::start(Station *from, const Bytes &payload, uint8_t hops) {
  Packet packet = {from, payload, now_, now_ + 42 + 6 * static_cast<uint32_t>(payload.size()), hops, {}};
  for (Packet &other : onAir_) {
    packet.others.push_back(other.from);
    other.others.push_back(from);
  }
  onAir_.push_back(packet);
  if (isMulticast(payload)) reached_[payload];
  if (onPacket) onPacket(payload);
}

long Air::missed(const Station &from, const Station &at) const {
  return std::count_if(reached_.begin(), reached_.end(),
                       [&](const std::pair<const Bytes, std::set<const Station *>> &each) {
                         return textOf(each.first).compare(4, 4, from.id) == 0 && each.second.count(&at) == 0;
                       });
}

void Air::finish(const Packet &packet) {
  if (packet.from != nullptr) packet.from->board.radio.finishSending();
  for (Station *station : stations_) {
    const bool apart = away_.count(station) != 0 || away_.count(packet.from) != 0;
    const bool broken = std::any_of(packet.others.begin(), packet.others.end(),
                                    [&](const Station *other) { return other == station || reaches(other, *station); });
    if (station == packet.from || apart || broken || !reaches(packet.from, *station)) continue;
    if (random.number(1000) < lostInThousand) continue;
    station->board.radio.arrive(packet.payload, {}, javinolib::Trailer::NONE, packet.hops);
    if (isMulticast(packet.payload)) reached_[packet.payload].insert(station);
  }
}

void Air::listen(Station &station) {
  station.board.radio.heard =
      hearsCarriers && std::any_of(onAir_.begin(), onAir_.end(), [&](const Packet &packet) {
        return packet.from != &station && reaches(packet.from, station) && now_ - packet.begin >= MILLIS_TO_CARRIER;
      });
}
