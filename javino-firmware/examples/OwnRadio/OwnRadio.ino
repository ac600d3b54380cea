// A radio of one's own: LoopbackRadio.h is a driver to begin it with. Here two of them are joined on one board, so that it
// needs no wiring: ALFA greets each second, and what BETA hears is printed at the serial monitor (115200 baud).

#include <Javino.h>

#include "LoopbackRadio.h"

const uint16_t INTERVAL_MILLIS = 1000;

LoopbackRadio radios[2];
javino::Broadcaster alfa(radios[0]);
javino::Broadcaster beta(radios[1]);
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
