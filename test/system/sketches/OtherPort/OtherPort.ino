// A board whose host is at another port than Serial: one that never tells how much room it has, as SoftwareSerial and others.

#include <JavinoBDI.h>

class SilentPort : public Stream {
 public:
  void begin(unsigned long baud) { Serial.begin(baud); }
  int available() override { return Serial.available(); }
  int read() override { return Serial.read(); }
  int peek() override { return Serial.peek(); }
  void flush() override { Serial.flush(); }
  size_t write(uint8_t byte) override { return Serial.write(byte); }
};

SilentPort port;
JavinoBoard board(port, "other 1.0");

void percepts(JavinoPercepts &p) { p.literal(digitalRead(LED_BUILTIN) ? F("led(on)") : F("led(off)")); }

bool ledOn(const JavinoArguments &) {
  digitalWrite(LED_BUILTIN, HIGH);
  return true;
}

void setup() {
  pinMode(LED_BUILTIN, OUTPUT);
  board.onPercepts(percepts);
  board.action(F("ledOn"), ledOn);
  board.begin(115200);
}

void loop() { board.run(); }
