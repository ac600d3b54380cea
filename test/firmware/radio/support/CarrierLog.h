#pragma once

#include <vector>

#include "Modem.h"

// When a modem heard a carrier, in bits since the log began.
class CarrierLog {
 public:
  struct Span {
    double begin, end;
  };

  explicit CarrierLog(Modem &modem);
  ~CarrierLog();

  // The carriers heard so far; a carrier that is heard still ends now.
  std::vector<Span> spans() const;

  // The share of the time during which one was heard.
  double share() const;

  // Whether it was heard without a break from one moment to another.
  bool covers(double begin, double end) const;

 private:
  double now() const { return double(modem_.hardware.time() - begun_) / Modem::BIT; }
  void look();

  Modem &modem_;
  const uint64_t begun_;
  bool heard_ = false;
  std::vector<Span> spans_;
};
