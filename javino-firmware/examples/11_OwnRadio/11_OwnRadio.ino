// Shows how to write a driver for another radio: begin with LoopbackRadio.h. Here two such drivers are joined on one board,
// without wiring: ALFA sends a greeting each second, and BETA prints it at the serial monitor (115200 baud).

#include <JavinoBDI.h>

#include "LoopbackRadio.h"

const uint16_t INTERVAL_MILLIS = 1000;

LoopbackRadio radios[2];
JavinoBroadcaster alfa(radios[0]);
JavinoBroadcaster beta(radios[1]);
uint32_t greetedAt = 0;

void print(const char *from, const char *text) {
  Serial.print(from);
  Serial.print(F(": "));
  Serial.println(text);
}

void setup() {
  Serial.begin(115200);
  radios[0].join(radios[1]);
  beta.onHeard(print);
  if (!alfa.begin("ALFA") || !beta.begin("BETA")) Serial.println(F("the radio does not start"));
}

void loop() {
  alfa.run();
  beta.run();
  if (millis() - greetedAt < INTERVAL_MILLIS) return;
  greetedAt += INTERVAL_MILLIS;
  alfa.send("hello");
}
