#include "AirLine.h"

#include <algorithm>
#include <cmath>

AirLine &AirLine::bits(const Bits &bits, double bitTicks) {
  for (bool bit : bits) hold(bit, bitTicks);
  return *this;
}

AirLine &AirLine::hold(bool level, double ticks) {
  if (runs_.empty()) runs_.push_back({false, 0});
  if (runs_.back().level == level) {
    runs_.back().ticks += ticks;
  } else {
    runs_.push_back({level, ticks});
  }
  return *this;
}

AirLine &AirLine::noise(double ticks, double longestPulse, std::mt19937 &random) {
  std::uniform_real_distribution<double> pulse(1, longestPulse);
  bool level = runs_.empty() || !runs_.back().level;
  for (double gone = 0; gone < ticks; level = !level) {
    const double length = std::min(pulse(random), ticks - gone);
    hold(level, length);
    gone += length;
  }
  return *this;
}

AirLine &AirLine::jitter(double ticks, std::mt19937 &random) {
  std::uniform_real_distribution<double> move(-ticks, ticks);
  std::vector<double> at = changes();
  for (size_t i = 0; i + 1 < at.size(); i++) at[i] = std::max(0.0, at[i] + move(random));
  std::sort(at.begin(), at.end());
  rebuild(at);
  return *this;
}

AirLine &AirLine::glitches(double length, double meanDistance, std::mt19937 &random) {
  std::exponential_distribution<double> distance(1 / meanDistance);
  std::vector<double> at = changes();
  const double end = at.back();
  at.pop_back();
  for (double begin = distance(random); begin + length < end; begin += length + distance(random)) {
    at.push_back(begin);
    at.push_back(begin + length);
  }
  std::sort(at.begin(), at.end());
  at.push_back(end);
  rebuild(at);
  return *this;
}

AirLine &AirLine::quantise(double ticks) {
  std::vector<double> at = changes();
  for (double &change : at) change = std::ceil(change / ticks) * ticks;
  rebuild(at);
  return *this;
}

bool AirLine::levelAt(double time) const {
  for (const Run &run : runs_) {
    if (time < run.ticks) return run.level;
    time -= run.ticks;
  }
  return false;
}

double AirLine::duration() const { return changes().back(); }

// The times at which runs end, the last one being the end of the line.
std::vector<double> AirLine::changes() const {
  std::vector<double> at;
  double time = 0;
  for (const Run &run : runs_) at.push_back(time += run.ticks);
  return at;
}

void AirLine::rebuild(const std::vector<double> &changes) {
  runs_.clear();
  double time = 0;
  bool level = false;
  for (double change : changes) {
    runs_.push_back({level, change - time});
    time = change;
    level = !level;
  }
}
