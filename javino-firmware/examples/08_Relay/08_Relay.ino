// A relay: devices that do not hear each other, but both hear this board, reach each other through it. It needs no computer,
// no address and no key, only power: put it where both hear it. See docs/how-to/set-up-a-relay.md.
//
// Wiring: 433 MHz receiver's data to pin 11, transmitter's data to pin 12.
// The lamp on the board lights up for a moment with each copy that is sent. The serial monitor (115200 baud) shows how many.
//
// If two relays hear each other, give each another number.

#include <JavinoBDI.h>

const uint16_t NUMBER = 1;
const uint16_t LIT_MILLIS = 100;

JavinoAskRadio radio;
JavinoRelay relay(radio);

uint32_t shown = 0;
uint32_t shownAt = 0;

void show(uint32_t sent) {
  Serial.print(F("messages copied: "));
  Serial.print(relay.copies());
  Serial.print(F(", acknowledgements: "));
  Serial.print(relay.answers());
  Serial.print(F(", refused: "));
  Serial.println(relay.refused());
  digitalWrite(LED_BUILTIN, HIGH);
  shown = sent;
  shownAt = millis();
}

void setup() {
  Serial.begin(115200);
  pinMode(LED_BUILTIN, OUTPUT);
  Serial.println(relay.begin(NUMBER) ? F("relaying") : F("the radio does not start"));
}

void loop() {
  relay.run();
  const uint32_t sent = relay.copies() + relay.answers();
  if (sent != shown && Serial.availableForWrite() > 60) show(sent);
  if (millis() - shownAt > LIT_MILLIS) digitalWrite(LED_BUILTIN, LOW);
}
