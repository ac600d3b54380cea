// A board with nothing but the radio, at any bit rate. With pin 40 high it sends packet after packet of the greatest
// length; otherwise it listens, and prints how many of such packets it has received undamaged.
//
// The bit rate is the last word of the EEPROM; 2000 where that is empty.

#include <JavinoBDI.h>
#include <avr/eeprom.h>
#include <avr/sleep.h>

const uint8_t SENDER_PIN = 40;
uint16_t *const RATE_PLACE = reinterpret_cast<uint16_t *>(4094);
const uint8_t LENGTH = 77;

uint16_t bitRate() {
  const uint16_t stored = eeprom_read_word(RATE_PLACE);
  return stored == 0xFFFF ? 2000 : stored;
}

JavinoAskRadio radio(11, 12, bitRate());
uint8_t payload[LENGTH];
uint32_t state = 1;
uint16_t received = 0;

void sendNext() {
  if (radio.sending()) return;
  for (uint8_t i = 0; i < LENGTH; i++) {
    state = state * 1664525 + 1013904223;
    payload[i] = state >> 24;
  }
  radio.send(payload, LENGTH);
}

void receiveNext() {
  JavinoReceived with;
  if (!radio.receive(with)) return;
  radio.release();
  if (with.length == LENGTH) Serial.println(++received);
}

void setup() {
  Serial.begin(115200);
  radio.begin();
}

void loop() {
  if (digitalRead(SENDER_PIN)) {
    sendNext();
  } else {
    receiveNext();
  }
  set_sleep_mode(SLEEP_MODE_IDLE);
  sleep_mode();
}
