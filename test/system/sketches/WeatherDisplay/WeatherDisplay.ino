// A DHT22, a display of two lines and a buzzer, as people build it: for its size on an Uno. The code in place of libraries is
// as large as theirs.
//
// Wiring: DHT22 to pin 3; display HD44780: RS to pin 4, E to pin 5, D4 to D7 to pins 6 to 9; buzzer to pin 10; receiver to
// pin 11, transmitter to pin 12.
//
// Actions:  beep(Hertz,Milliseconds), show("text"), clear
// Percepts: temperature(Celsius), humidity(Percent)

#include <JavinoBDI.h>

const uint8_t DHT = 3, DISPLAY_RS = 4, DISPLAY_ENABLE = 5, DISPLAY_DATA = 6, BUZZER = 10;

// Prints to a display of two lines that is fed four bits at a time.
class Display : public Print {
 public:
  void begin() {
    for (uint8_t pin = DISPLAY_RS; pin < DISPLAY_DATA + 4; pin++) pinMode(pin, OUTPUT);
    delay(50);
    for (uint8_t i = 0; i < 3; i++) {
      sendNibble(0x3);
      delay(5);
    }
    sendNibble(0x2);
    command(0x28);
    command(0x0C);
    command(0x06);
    clear();
  }

  void clear() {
    command(0x01);
    delay(2);
  }

  void setCursor(uint8_t column, uint8_t row) { command(0x80 | (row * 0x40 + column)); }

  size_t write(uint8_t character) override {
    digitalWrite(DISPLAY_RS, HIGH);
    send(character);
    return 1;
  }

 private:
  void command(uint8_t code) {
    digitalWrite(DISPLAY_RS, LOW);
    send(code);
  }

  void send(uint8_t byte) {
    sendNibble(byte >> 4);
    sendNibble(byte & 0x0F);
    delayMicroseconds(50);
  }

  void sendNibble(uint8_t nibble) {
    for (uint8_t i = 0; i < 4; i++) digitalWrite(DISPLAY_DATA + i, nibble >> i & 1);
    digitalWrite(DISPLAY_ENABLE, HIGH);
    delayMicroseconds(1);
    digitalWrite(DISPLAY_ENABLE, LOW);
  }
};

Display display;
JavinoAskRadio radio;
JavinoUnicastBoard board(Serial, "weather 1.0", radio);

float temperature = NAN, humidity = NAN;
unsigned long measuredAt;

// Waits for a change of the sensor's line; returns for how many turns it was at a level, 0 if for too long.
uint16_t pulse(uint8_t level) {
  uint16_t turns = 0;
  while (digitalRead(DHT) == level) {
    if (++turns == 1000) return 0;
  }
  return turns;
}

// Reads five bytes, the last of which is the sum of the others.
bool measure() {
  uint8_t bytes[5] = {};
  pinMode(DHT, OUTPUT);
  digitalWrite(DHT, LOW);
  delayMicroseconds(1100);
  pinMode(DHT, INPUT_PULLUP);
  delayMicroseconds(55);
  noInterrupts();
  bool whole = pulse(LOW) && pulse(HIGH);
  for (uint8_t i = 0; whole && i < 40; i++) {
    const uint16_t low = pulse(LOW);
    const uint16_t high = pulse(HIGH);
    bytes[i / 8] = bytes[i / 8] << 1 | (high > low);
    whole = low && high;
  }
  interrupts();
  if (!whole || static_cast<uint8_t>(bytes[0] + bytes[1] + bytes[2] + bytes[3]) != bytes[4]) return false;
  humidity = (bytes[0] << 8 | bytes[1]) * 0.1;
  temperature = ((bytes[2] & 0x7F) << 8 | bytes[3]) * 0.1;
  if (bytes[2] & 0x80) temperature = -temperature;
  return true;
}

bool beep(const JavinoArguments &arguments) {
  long hertz, millis;
  if (!arguments.integer(0, hertz) || !arguments.integer(1, millis)) return false;
  tone(BUZZER, hertz, millis);
  return true;
}

bool show(const JavinoArguments &arguments) {
  char text[17];
  if (!arguments.text(0, text, sizeof text)) return false;
  display.setCursor(0, 1);
  display.print(text);
  return true;
}

bool clear(const JavinoArguments &) {
  display.clear();
  return true;
}

void perceive(JavinoPercepts &percepts) {
  percepts.add(F("temperature"), temperature, 0.2);
  percepts.add(F("humidity"), humidity, 1.0);
}

void setup() {
  display.begin();
  board.onPercepts(perceive);
  board.action(F("beep"), beep);
  board.action(F("show"), show);
  board.action(F("clear"), clear);
  board.begin(115200);
}

void loop() {
  board.run();
  if (millis() - measuredAt < 2500) return;
  measuredAt = millis();
  display.setCursor(0, 0);
  if (measure()) {
    display.print(temperature, 1);
    display.print(F(" C  "));
    display.print(humidity, 1);
    display.print(F(" %  "));
  } else {
    display.print(F("no sensor"));
  }
}
