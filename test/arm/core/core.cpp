#include <Arduino.h>
#if __has_include(<EEPROM.h>)
#include <EEPROM.h>
#define HAS_EEPROM
#endif

// Parts of the core beside the chip: texts, pins, EEPROM.

#ifdef CORE_HAS_USB
UsbSerial Serial;
#else
HardwareSerial Serial(0);
#endif
HardwareSerial Serial1(2);
static HardwareSerial test(1);  // what the board tells the test, and is told

namespace {

const uint8_t PINS = 20;
const uint8_t PULSE = 2;

uint8_t levels[PINS];
uint16_t voltages[PINS - A0];
#ifdef HAS_EEPROM
uint8_t flash[4096] __attribute__((section(".noinit")));
#endif

const uint32_t SYSTEM_RESET = 0x05FA0004;

void command(const char *line) {
  const char *const numbers = strchr(line, ' ');
  long values[2] = {0, 0};
  uint8_t count = 0;
  for (const char *at = numbers; at != nullptr && count != 2; at = strchr(at, ' ')) {
    for (at++; *at >= '0' && *at <= '9'; at++) values[count] = values[count] * 10 + *at - '0';
    count++;
  }
  switch (*line) {
    case 'a': voltages[values[0]] = static_cast<uint16_t>(values[1]); break;
    case 'd': levels[values[0]] = static_cast<uint8_t>(values[1]); break;
    case 'p': levels[values[0]] = PULSE; break;
    case 'r': *reinterpret_cast<volatile uint32_t *>(0xE000ED0C) = SYSTEM_RESET; break;
  }
}

void readCommands() {
  static char line[32];
  static uint8_t length;
  while (test.available() > 0) {
    const char next = static_cast<char>(test.read());
    line[length] = next == '\n' ? 0 : next;
    length = next == '\n' ? 0 : (length + 1) % sizeof line;
    if (next == '\n') command(line);
  }
}

}  // namespace

int main() {
  test.begin(115200);
  setup();
  while (true) {
    loop();
    readCommands();
    if (serialEvent != nullptr && Serial.available() > 0) serialEvent();
  }
}

void delay(unsigned long time) {
  for (const unsigned long begin = millis(); millis() - begin < time;) yield();
}

void pinMode(uint8_t, uint8_t) {}

void digitalWrite(uint8_t pin, uint8_t level) {
  if (levels[pin] == level) return;
  levels[pin] = level;
  if (pin == LED_BUILTIN)
    test.println((String("pin ") + String(static_cast<int>(pin)) + ' ' + String(static_cast<int>(level))).c_str());
}

int digitalRead(uint8_t pin) {
  if (levels[pin] != PULSE) return levels[pin];
  levels[pin] = LOW;
  return HIGH;
}

int analogRead(uint8_t pin) { return voltages[pin - A0]; }

long map(long value, long fromLow, long fromHigh, long toLow, long toHigh) {
  return (value - fromLow) * (toHigh - toLow) / (fromHigh - fromLow) + toLow;
}

unsigned long pulseIn(uint8_t, uint8_t, unsigned long) { return 0; }

#ifdef HAS_EEPROM

EEPROMClass EEPROM;

void EEPROMClass::begin(size_t size) { memcpy(copy_, flash, size); }

bool EEPROMClass::commit() {
  memcpy(flash, copy_, sizeof flash);
  return true;
}

#endif

namespace arduino {

String::String(long number) {
  char digits[12];
  char *first = digits + sizeof digits;
  *--first = 0;
  unsigned long rest = number < 0 ? 0 - static_cast<unsigned long>(number) : static_cast<unsigned long>(number);
  do *--first = static_cast<char>('0' + rest % 10);
  while ((rest /= 10) != 0);
  if (number < 0) *--first = '-';
  *this += first;
}

String::String(double number) : String(static_cast<long>(number)) {
  const long hundredths = lround(fabs(number) * 100);
  *this = (number < 0 ? String("-") : String()) + String(hundredths / 100) + '.' +
          static_cast<char>('0' + hundredths / 10 % 10) + static_cast<char>('0' + hundredths % 10);
}

String &String::operator+=(const char *text) {
  strncat(text_, text, sizeof text_ - 1 - length());
  return *this;
}

String &String::operator+=(char character) {
  const char text[] = {character, 0};
  return *this += text;
}

int String::indexOf(char character, unsigned int from) const {
  const char *const at = strchr(text_ + from, character);
  return at == nullptr ? -1 : at - text_;
}

String String::substring(unsigned int from, unsigned int to) const {
  String part = text_ + from;
  part.text_[to - from] = 0;
  return part;
}

void Stream::print(const char *text) {
  while (*text != 0) write(static_cast<uint8_t>(*text++));
}

}  // namespace arduino
