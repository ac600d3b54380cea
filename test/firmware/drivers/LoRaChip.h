#pragma once

#include <HardwareEmulation.hpp>
#include <RadioLib.h>

#include <functional>
#include <vector>

#include "support/Bytes.h"

class LoRaChip;

/// What emulated chips share: time, and the packets in it.
class LoRaAir {
 public:
  struct Packet {
    const LoRaChip *from;
    uint64_t begun, hasHeader, ends;  // in us
    uint64_t symbol;
    Bytes bytes;
    bool damaged;
  };

  /// Lets time pass, in steps of a quarter of a millisecond.
  void pass(uint32_t millis);

  void send(const LoRaChip *from, uint64_t symbol, uint64_t untilHeader, uint64_t micros, const Bytes &bytes);

  /// Ends what is on the air, unheard.
  void breakOff() { packets_.clear(); }

  /// The packet of another chip that is on the air.
  Packet *heardBy(const LoRaChip *chip);

  uint64_t micros = 0;
  std::vector<LoRaChip *> chips;
  unsigned lost = 0;         ///< so many of the next packets are damaged
  unsigned collisions = 0;   ///< packets that began while another was on the air
  std::vector<Packet> past;  ///< what was on the air
  std::function<bool(const LoRaChip *, const LoRaChip *)> reaches = [](const LoRaChip *, const LoRaChip *) {
    return true;
  };

 private:
  std::vector<Packet> packets_;
};

/// The LoRa modem of an SX1276…1279 at its registers and pins, on RadioLib's seam for emulated hardware, and of an Arduino what
/// RadioLib needs of it. RadioLib's own TestHal sleeps for a millisecond a byte.
class LoRaChip : public EmulatedRadio, public RadioLibHal {
 public:
  explicit LoRaChip(LoRaAir &air);

  /// What time does to the chip.
  void update();

  // For the chip's driver.
  uint8_t HandleSPI(uint8_t byte) override;
  void HandleGPIO() override;

  void pinMode(uint32_t, uint32_t) override {}
  void digitalWrite(uint32_t pin, uint32_t value) override;
  uint32_t digitalRead(uint32_t pin) override { return pins_[pin].value; }
  void attachInterrupt(uint32_t, void (*call)(), uint32_t) override { interrupt_ = call; }
  void detachInterrupt(uint32_t) override { interrupt_ = nullptr; }
  void delay(RadioLibTime_t millis) override { delayMicroseconds(1000 * millis); }
  void delayMicroseconds(RadioLibTime_t micros) override { waited += micros; }
  RadioLibTime_t millis() override { return micros() / 1000; }
  RadioLibTime_t micros() override { return static_cast<RadioLibTime_t>(air_.micros + waited); }
  long pulseIn(uint32_t, uint32_t, RadioLibTime_t) override { return 0; }
  void spiBegin() override {}
  void spiBeginTransaction() override {}
  void spiTransfer(uint8_t *out, size_t length, uint8_t *in) override;
  void spiEndTransaction() override {}
  void spiEnd() override {}

  uint64_t waited = 0;     ///< microseconds in delays
  bool interrupts = true;  ///< false: its pin is not connected
  unsigned scans = 0;      ///< scans of the channel

 private:
  enum Mode : uint8_t { SLEEP, STANDBY, TRANSMITS = 3, LISTENS = 5, SCANS = 7 };

  Mode mode() const { return static_cast<Mode>(registers_[1] & 7); }
  void setMode(Mode mode);
  void write(uint8_t byte);
  void raise(uint8_t flag);
  void updatePin();
  double symbolMicros() const;
  double symbolsOf(size_t length) const;

  LoRaAir &air_;
  EmulatedPin_t pins_[8] = {};
  void (*interrupt_)() = nullptr;
  uint8_t registers_[0x80] = {};
  uint8_t fifo_[0x100] = {};
  int at_ = -1;  // the register of this transaction
  bool writes_ = false;
  uint64_t since_ = 0, until_ = 0;  // of the mode
};
