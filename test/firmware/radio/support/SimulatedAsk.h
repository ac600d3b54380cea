#pragma once

#include <cstdint>
#include <functional>
#include <random>
#include <vector>

#include "AirLine.h"
#include "radio/AskRadio.h"

// The timer and the pins of a board, in simulated time: the other side of radio/AskHardware.h. One at a time exists.
class SimulatedAsk {
 public:
  static const uint32_t TICKS_PER_SECOND = 2000000;  // a Mega's
  static const uint8_t PIN_WITHOUT_EDGES = 4;

  struct Change {
    uint64_t time;
    bool level;
  };

  SimulatedAsk();
  ~SimulatedAsk();
  static SimulatedAsk &current();

  // Interrupts come late by up to so many ticks.
  void delayInterrupts(uint32_t mostTicks) { mostDelay_ = mostTicks; }

  // Called after each interrupt: nothing changes between two of them.
  void afterInterrupts(std::function<void()> hook) { afterInterrupt_ = std::move(hook); }

  // Lets the RX pin follow the line, then stay where the line left it.
  void play(const AirLine &line);

  // Lets time pass.
  void wait(uint64_t ticks);

  uint64_t time() const { return time_; }
  bool quiet() const { return !alarmOn_; }
  uint32_t interrupts() const { return interrupts_; }
  bool carrier() const { return carrier_; }
  const std::vector<Change> &carrierChanges() const { return carrierChanges_; }

  // The functions of askhardware here.
  bool begin(uint8_t rxPin, uint8_t txPin, javinolib::AskRadio &radio);
  uint16_t now() const { return static_cast<uint16_t>(time_); }
  void setAlarm(uint16_t at);
  void clearAlarm() { alarmOn_ = false; }
  void watchEdges(bool on);
  void transmit(bool on);

 private:
  void setRx(bool level);
  void runUntil(uint64_t time);
  uint32_t delay();

  static SimulatedAsk *current_;
  std::function<void()> afterInterrupt_ = [] {};
  javinolib::AskRadio *radio_ = nullptr;
  std::mt19937 random_;
  uint32_t mostDelay_ = 0;
  uint64_t time_ = 65000;  // the timer is about to overflow
  uint32_t interrupts_ = 0;
  bool rx_ = false;
  bool watching_ = false;
  bool edgePending_ = false;
  uint64_t edgeAt_ = 0;
  bool alarmOn_ = false;
  uint64_t alarmAt_ = 0;
  bool carrier_ = false;
  std::vector<Change> carrierChanges_;
};
