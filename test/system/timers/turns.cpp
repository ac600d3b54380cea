// How often loop() turns: the pin changes every 16 turns. -D CALL=run or serve; with RADIO the board has one.

#include <Arduino.h>

#include <JavinoBDI.h>

const uint8_t PIN = 8;
const uint8_t TURNS = 16;

#ifdef RADIO
JavinoAskRadio radio;
JavinoRadioBoard board(Serial, "turns 1.0", radio);
#else
JavinoBoard board(Serial, "turns 1.0");
#endif
uint8_t turns;

void setup() {
  pinMode(PIN, OUTPUT);
  board.begin(115200);
}

void loop() {
  board.CALL();
  if (++turns % TURNS == 0) digitalWrite(PIN, !digitalRead(PIN));
}
