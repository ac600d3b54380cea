#pragma once

/// An Arduino core for tests, with what their sketches need: an ARM Cortex-M3 as QEMU emulates it (mps2-an385). Names are in a
/// namespace, as in ArduinoCore-API, which most newer cores share.
///
/// `Serial` is the first UART. On the second one the board tells each change of a pin, `pin 13 1`, and is told what its inputs
/// read: `analog 0 512`, `digital 2 1`, `pulse 2` (1 at the next reading only); and `reset`.
///
/// It is odd as other cores are, on demand: with CORE_WITHOUT_ROOM no port has availableForWrite(), with CORE_TELLS_NO_ROOM it is
/// 0 for ever; with CORE_HAS_USB `Serial` is of another type than `Serial1`; CORE_MACROS names a file of macros. EEPROM.h is in a
/// folder of its own.

#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#define HIGH 1
#define LOW 0
#define INPUT 0
#define OUTPUT 1
#define INPUT_PULLUP 2
#define LED_BUILTIN 13
#define PROGMEM
#define PSTR(text) (text)
#define F(text) (reinterpret_cast<const __FlashStringHelper *>(PSTR(text)))
#define pgm_read_byte(at) (*(const unsigned char *)(at))
#define constrain(value, low, high) ((value) < (low) ? (low) : ((value) > (high) ? (high) : (value)))

static const uint8_t A0 = 14;
static const uint8_t A1 = 15;

namespace arduino {

class __FlashStringHelper;

/// A text of some hundred characters; what is longer is cut off. It uses no heap.
class String {
 public:
  String(const char *text = "") { *this += text; }
  explicit String(long number);
  explicit String(int number) : String(static_cast<long>(number)) {}
  explicit String(unsigned long number) : String(static_cast<long>(number)) {}
  explicit String(double number);
  String(const __FlashStringHelper *text) : String(reinterpret_cast<const char *>(text)) {}

  String &operator+=(const char *text);
  String &operator+=(const String &other) { return *this += other.text_; }
  String &operator+=(char character);
  bool operator==(const String &other) const { return strcmp(text_, other.text_) == 0; }

  const char *c_str() const { return text_; }
  unsigned int length() const { return strlen(text_); }
  char operator[](unsigned int at) const { return text_[at]; }
  int indexOf(char character, unsigned int from = 0) const;
  String substring(unsigned int from, unsigned int to) const;

 private:
  char text_[512] = "";
};

inline String operator+(String one, const String &other) { return one += other; }
inline String operator+(String one, char character) { return one += character; }

class Stream {
 public:
  virtual int available() = 0;
  virtual int read() = 0;
  virtual size_t write(uint8_t byte) = 0;
#ifndef CORE_WITHOUT_ROOM
  virtual int availableForWrite() { return 0; }
#endif

  void print(const char *text);
  void print(const __FlashStringHelper *text) { print(reinterpret_cast<const char *>(text)); }
  template <typename Text>
  void println(Text text) {
    print(text);
    print("\r\n");
  }
};

class HardwareSerial : public Stream {
 public:
  explicit HardwareSerial(uint8_t number) : number_(number) {}

  void begin(unsigned long baud);
  int available() override { return static_cast<uint8_t>(end_ - begin_); }
  int read() override;
  size_t write(uint8_t byte) override;
#if !defined(CORE_WITHOUT_ROOM) && !defined(CORE_TELLS_NO_ROOM)
  int availableForWrite() override;
#endif

  void onReceived();

 private:
  uint8_t room() const { return sizeof received_ - static_cast<uint8_t>(end_ - begin_); }

  const uint8_t number_;
  volatile uint8_t begin_ = 0, end_ = 0;  // of what was received, modulo its size
  uint8_t received_[64];
};

/// The host's line on a chip with USB, which is the first UART nevertheless.
class UsbSerial : public Stream {
 public:
  void begin(unsigned long) { uart_.begin(115200); }
  int available() override { return uart_.available(); }
  int read() override { return uart_.read(); }
  size_t write(uint8_t byte) override { return uart_.write(byte); }

 private:
  HardwareSerial uart_{0};
};

}  // namespace arduino

using namespace arduino;

#ifdef CORE_HAS_USB
extern UsbSerial Serial;
#else
extern HardwareSerial Serial;
#endif
extern HardwareSerial Serial1;

void setup();
void loop();
void serialEvent() __attribute__((weak));

unsigned long millis();
unsigned long micros();
void delay(unsigned long millis);
void delayMicroseconds(unsigned int micros);
void yield();
void pinMode(uint8_t pin, uint8_t mode);
void digitalWrite(uint8_t pin, uint8_t level);
int digitalRead(uint8_t pin);
int analogRead(uint8_t pin);
long map(long value, long fromLow, long fromHigh, long toLow, long toHigh);
unsigned long pulseIn(uint8_t pin, uint8_t level, unsigned long timeout);
inline void tone(uint8_t, unsigned int) {}
inline void noTone(uint8_t) {}

#ifdef CORE_MACROS
#include CORE_MACROS
#endif
