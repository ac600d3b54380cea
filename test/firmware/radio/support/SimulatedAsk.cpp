#include "SimulatedAsk.h"

#include <algorithm>
#include <stdexcept>

#include "radio/AskHardware.h"

SimulatedAsk *SimulatedAsk::current_ = nullptr;

SimulatedAsk::SimulatedAsk() : random_(11) { current_ = this; }

SimulatedAsk::~SimulatedAsk() { current_ = nullptr; }

SimulatedAsk &SimulatedAsk::current() {
  if (!current_) throw std::logic_error("no simulated hardware");
  return *current_;
}

void SimulatedAsk::play(const AirLine &line) {
  double at = static_cast<double>(time_);
  for (const AirLine::Run &run : line.runs()) {
    runUntil(static_cast<uint64_t>(at));
    if (run.ticks > 0) setRx(run.level);
    at += run.ticks;
  }
  runUntil(static_cast<uint64_t>(at));
}

void SimulatedAsk::wait(uint64_t ticks) { runUntil(time_ + ticks); }

bool SimulatedAsk::begin(uint8_t rxPin, uint8_t txPin, javinolib::AskRadio &radio) {
  radio_ = &radio;
  return rxPin != PIN_WITHOUT_EDGES && rxPin != txPin;
}

// As the hardware: a value that is now is met only a round later.
void SimulatedAsk::setAlarm(uint16_t at) {
  alarmOn_ = true;
  alarmAt_ = (time_ & ~0xFFFFull) + at;
  if (alarmAt_ <= time_) alarmAt_ += 0x10000;
}

void SimulatedAsk::watchEdges(bool on) {
  watching_ = on;
  edgePending_ = false;
}

void SimulatedAsk::transmit(bool on) {
  if (on != carrier_) carrierChanges_.push_back({time_, on});
  carrier_ = on;
}

void SimulatedAsk::setRx(bool level) {
  if (level == rx_) return;
  rx_ = level;
  if (!watching_ || edgePending_) return;
  edgePending_ = true;
  edgeAt_ = time_ + delay();
}

void SimulatedAsk::runUntil(uint64_t time) {
  for (;;) {
    const bool edgeIsNext = edgePending_ && (!alarmOn_ || edgeAt_ <= alarmAt_);
    if (edgeIsNext && edgeAt_ <= time) {
      time_ = std::max(time_, edgeAt_);
      edgePending_ = false;
      interrupts_++;
      radio_->onEdge(now(), rx_);
      afterInterrupt_();
    } else if (!edgeIsNext && alarmOn_ && alarmAt_ <= time) {
      time_ = std::max(time_, alarmAt_);
      alarmAt_ += 0x10000;
      interrupts_++;
      radio_->onAlarm();
      afterInterrupt_();
    } else {
      break;
    }
  }
  time_ = std::max(time_, time);
}

uint32_t SimulatedAsk::delay() { return mostDelay_ == 0 ? 0 : random_() % (mostDelay_ + 1); }

namespace javinolib {
namespace askhardware {

uint32_t ticksPerSecond() { return SimulatedAsk::TICKS_PER_SECOND; }
bool begin(uint8_t rxPin, uint8_t txPin, AskRadio &radio) { return SimulatedAsk::current().begin(rxPin, txPin, radio); }
uint16_t now() { return SimulatedAsk::current().now(); }
void setAlarm(uint16_t at) { SimulatedAsk::current().setAlarm(at); }
void clearAlarm() { SimulatedAsk::current().clearAlarm(); }
void watchEdges(bool on) { SimulatedAsk::current().watchEdges(on); }
void transmit(bool on) { SimulatedAsk::current().transmit(on); }

// Simulated interrupts come only while the test lets time pass: there is nothing to lock.
InterruptLock::InterruptLock() : before_(0) {}
InterruptLock::~InterruptLock() {}

}  // namespace askhardware
}  // namespace javinolib
