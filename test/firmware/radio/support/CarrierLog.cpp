#include "CarrierLog.h"

CarrierLog::CarrierLog(Modem &modem) : modem_(modem), begun_(modem.hardware.time()) {
  modem_.hardware.afterInterrupts([this] { look(); });
  look();
}

CarrierLog::~CarrierLog() {
  modem_.hardware.afterInterrupts([] {});
}

std::vector<CarrierLog::Span> CarrierLog::spans() const {
  std::vector<Span> spans = spans_;
  if (heard_) spans.back().end = now();
  return spans;
}

double CarrierLog::share() const {
  double heard = 0;
  for (const Span &span : spans()) heard += span.end - span.begin;
  return heard / now();
}

bool CarrierLog::covers(double begin, double end) const {
  for (const Span &span : spans()) {
    if (span.begin <= begin && span.end >= end) return true;
  }
  return false;
}

void CarrierLog::look() {
  const bool heard = modem_.hearsCarrier();
  if (heard && !heard_) spans_.push_back({now(), 0});
  if (!heard && heard_) spans_.back().end = now();
  heard_ = heard;
}
