#pragma once

/// The part of the Arduino core that Javino's tests need. Every call goes to the gmock object that is alive:
/// ArduinoMock, SerialMock.

#include <stddef.h>
#include <stdint.h>

#include "WString.h"

enum : uint8_t { LOW = 0, HIGH = 1 };
enum : uint8_t { INPUT = 0, OUTPUT = 1, INPUT_PULLUP = 2 };

/// A text in flash; here it is in memory like any other.
#define F(text) (reinterpret_cast<const __FlashStringHelper *>(text))

void pinMode(uint8_t pin, uint8_t mode);
void digitalWrite(uint8_t pin, uint8_t value);
int digitalRead(uint8_t pin);
int analogRead(uint8_t pin);
unsigned long millis();
unsigned long micros();
void yield();

class Stream {
 public:
  virtual int available() = 0;
  virtual int read() = 0;
  virtual int availableForWrite() = 0;
  virtual size_t write(uint8_t byte) = 0;

 protected:
  ~Stream() = default;
};

class HardwareSerial : public Stream {
 public:
  void begin(unsigned long baud);
  int available() override;
  int read() override;
  int availableForWrite() override;
  size_t write(uint8_t byte) override;
};

extern HardwareSerial Serial;
