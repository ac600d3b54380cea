#pragma once

#include <stddef.h>
#include <stdint.h>

#include "BitClock.h"
#include "Mender.h"
#include "Radio.h"
#include "RadioDecoder.h"
#include "RadioEncoder.h"
#include "../support/Part.h"
#include "../support/Zeroed.h"

// Libraries that take the radio's timer, as far as a file includes them before this one. All others the linker finds, or
// takenTimer().
#if !defined(JAVINO_RADIO_TIMER) || JAVINO_RADIO_TIMER == 1
#if defined(Servo_h) && !defined(OCR5BL)
#define JAVINO_TIMER_IS_TAKEN_BY "Servo"
#elif defined(TimerOne_h_)
#define JAVINO_TIMER_IS_TAKEN_BY "TimerOne"
#elif defined(IR_USE_AVR_TIMER1)
#define JAVINO_TIMER_IS_TAKEN_BY "IRremote"
#endif
#elif JAVINO_RADIO_TIMER == 5 && defined(Servo_h)
#define JAVINO_TIMER_IS_TAKEN_BY "Servo"
#elif (JAVINO_RADIO_TIMER == 3 && defined(IR_USE_AVR_TIMER3)) || \
    (JAVINO_RADIO_TIMER == 4 && defined(IR_USE_AVR_TIMER4)) || (JAVINO_RADIO_TIMER == 5 && defined(IR_USE_AVR_TIMER5))
#define JAVINO_TIMER_IS_TAKEN_BY "IRremote"
#endif

namespace javinolib {

/// The modem for cheap 433 MHz on-off-keying pairs (SPEC 6): one interrupt a bit while sending, one an edge while
/// receiving, none while the air is quiet.
///
/// Takes timer 1, or the one that a sketch names (AskHardwareAvrTimer.h), and so the PWM of its pins, and the pin-change
/// interrupts. Everything happens in interrupts, which are short and never wait; the loop only fetches what came. Half
/// duplex: nothing is received while sending, and a packet that was half received then counts as missed.
///
/// On an AVR a global or static object (support/Zeroed.h).
class AskRadio : public Radio {
 public:
  static void *operator new(size_t) = delete;

  static const uint16_t MIN_BIT_RATE = 200;
  static const uint16_t MAX_BIT_RATE = 10000;

  /// @param rxPin digital pin of the receiver's data; it must have a pin-change interrupt (Mega: 10-15, 50-53, A8-A15; Leonardo: 8-11,
  /// 14-17; the others: all)
  /// @param txPin digital pin of the transmitter's data
  /// @param bitRate bits a second, 200…10000 and no more than a 16th of the timer's rate; the same on all boards
#ifndef JAVINO_TIMER_IS_TAKEN_BY
  explicit AskRadio(uint8_t rxPin = 11, uint8_t txPin = 12, uint16_t bitRate = 2000);
#else
  template <typename Radio = AskRadio>
  explicit AskRadio(uint8_t = 11, uint8_t = 12, uint16_t = 2000) : AskRadio(static_cast<Radio *>(nullptr)) {
    static_assert(sizeof(Radio) == 0, JAVINO_TIMER_IS_TAKEN_BY
                  " takes the radio's timer: write #define JAVINO_RADIO_TIMER 0 before you include JavinoBDI.h");
  }
  AskRadio(AskRadio *);
#endif

  bool begin() override;
  bool send(const uint8_t *payload, uint8_t length) override;
  bool sending() const override { return sending_; }
  bool carrier() const override;
  uint8_t longestPayload() const override { return MAX_RADIO_PAYLOAD; }
  uint16_t airtimeMillis(uint8_t length) const override;
  uint8_t slotMillis() const override;
  uint8_t *receive(Received &with) override;
  void release() override;
  Mender *mender() override { return mender_.operator->(); }
  uint8_t *sentPath() override { return &path_; }
#if JAVINO_LARGE
  uint8_t follow(Trailer trailer, uint8_t length) override;
#endif
  void counters(RadioCounters &into) const override;
  bool idle() const override { return decoder_->queue().empty(); }

  /// Interrupt: the RX pin went to this level.
  void onEdge(uint16_t now, bool level);

  /// Interrupt: the alarm's time has come.
  void onAlarm();

 private:
  void count(config::Count &counter);
  void setAlarm(uint16_t at);
  void startReceiving();
  void stopReceiving();
  void lookAtLine();
  void hear(uint16_t now, uint16_t least = 0);
  void onSilence();
  bool isHeldByCollision() const;
  void sendBit();
  void finishSending();

  const uint8_t rxPin_;
  const uint8_t txPin_;
  const uint16_t bitRate_;
  const uint16_t bitTicks_;  // 0 for a bit rate that cannot be had

  // The small fields first: gcc reaches the first 63 bytes of an object in one instruction (240 bytes of flash less).
  bool ready_ JAVINO_ZEROED;  // begin() succeeded
  volatile bool sending_ JAVINO_ZEROED;
  bool nextBit_ JAVINO_ZEROED;     // computed ahead, so that the carrier switches first thing in the interrupt
  bool lastBitOut_ JAVINO_ZEROED;  // the last bit is on the air: the next alarm ends the packet
  mutable bool carrierHeard_ JAVINO_ZEROED;  // since carrier() was called, or when it was
  uint16_t alarm_ JAVINO_ZEROED;             // when the timer's interrupt is to begin
  uint16_t late_ JAVINO_ZEROED;              // by how many ticks it was late at most
  uint8_t alarmsLeft_ JAVINO_ZEROED;         // without an edge; 0: the air is quiet, the alarm is off
  uint16_t heardUntil_ JAVINO_ZEROED;        // the time up to which the line has been heard
  bool level_ JAVINO_ZEROED;                 // of the line since then

  OwnPart<BitClock> bitClock_;
  OwnPart<RadioEncoder> encoder_;
  Trailer follower_ JAVINO_ZEROED;  // what follows the packets that are sent
  uint8_t path_ JAVINO_ZEROED;      // behind these
  OwnPart<RadioDecoder> decoder_;
  OwnPart<Mender> mender_;
};

}  // namespace javinolib
