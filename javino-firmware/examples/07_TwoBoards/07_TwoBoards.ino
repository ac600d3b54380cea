// Two boards chat by radio, without any agent: type a line at the serial monitor of one (115200 baud, any line ending),
// and the other prints it, and each further board in range too.
//
// Wiring of both boards: 433 MHz receiver's data to pin 11, transmitter's data to pin 12.
// On one of them connect pin 2 to GND: that board has the address BETA, the other one ALFA.
//
// Anybody can read and forge these messages. Agents in range understand lines in their form: tell;hello

#include <JavinoBDI.h>

const uint8_t ADDRESS_PIN = 2;
const uint8_t MAX_TEXT = JavinoBroadcaster::MAX_TEXT;

JavinoAskRadio radio;
JavinoBroadcaster broadcaster(radio);

char line[MAX_TEXT + 1];
uint8_t length = 0;  // MAX_TEXT + 1 if more came
bool complete = false;

void print(const char *from, const char *text) {
  Serial.print(from);
  Serial.print(F(": "));
  Serial.println(text);
}

void take(char typed) {
  if (typed == '\n' || typed == '\r') {
    complete = length != 0;
    return;
  }
  if (length < MAX_TEXT) line[length] = typed;
  if (length <= MAX_TEXT) length++;
}

void sendLine() {
  if (length > MAX_TEXT) {
    Serial.println(F("too long, not sent: 67 bytes at most"));
  } else {
    line[length] = '\0';
    broadcaster.send(line);
  }
  length = 0;
  complete = false;
}

void setup() {
  Serial.begin(115200);
  pinMode(ADDRESS_PIN, INPUT_PULLUP);
  const char *address = digitalRead(ADDRESS_PIN) ? "ALFA" : "BETA";
  broadcaster.onHeard(print);
  print(address, broadcaster.begin(address) ? "type a line" : "the radio does not start");
}

void loop() {
  broadcaster.run();
  while (!complete && Serial.available()) take(Serial.read());
  if (complete && !broadcaster.isBusy()) sendLine();
}
