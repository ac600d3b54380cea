// A radio, and what else a sketch may do with timers: -D NEIGHBOUR=(one of the functions below), -D JAVINO_RADIO_TIMER=(the radio's). With
// NEIGHBOUR_FIRST its header comes first, and it begins first. With HOSTED the board has a host, with RELAYS it is a relay; else it
// broadcasts, with ANSWERS only what it has heard.

#include <Arduino.h>

#ifdef NEIGHBOUR_FIRST
#include NEIGHBOUR_HEADER
#endif
#include <JavinoBDI.h>
#ifndef NEIGHBOUR_FIRST
#include NEIGHBOUR_HEADER
#endif

#ifdef __AVR_ATmega2560__
const uint8_t OUT_PIN = 22, HEARD_PIN = 24, BEGUN_PIN = 26;
#else
const uint8_t OUT_PIN = 4, HEARD_PIN = 7, BEGUN_PIN = 8;
#endif
const uint16_t SEND_MILLIS = 400;  // for a packet and its answer

#ifndef RX_PIN
#define RX_PIN 11
#endif
JavinoAskRadio radio(RX_PIN);
#ifdef HOSTED
JavinoRadioBoard board(Serial, "neighbour 1.0", radio);
#elif defined(RELAYS)
JavinoRelay relay(radio);
#else
JavinoBroadcaster broadcaster(radio);
#endif
bool hasHeard;

static void toggle() { digitalWrite(OUT_PIN, !digitalRead(OUT_PIN)); }

#if defined(Servo_h)
#ifndef SERVOS
#define SERVOS 1
#endif
Servo servos[SERVOS];
static void begin() {
  for (uint8_t i = 0; i != SERVOS - 1; i++) servos[i].attach(0);
  servos[SERVOS - 1].attach(OUT_PIN);
}
#elif defined(TimerOne_h_)
static void begin() {
  Timer1.initialize(5000);
  Timer1.attachInterrupt(toggle);
}
#elif defined(_IR_REMOTE_HPP)
static void sampled() {
  static uint8_t samples;
  if (++samples != 100) return;
  samples = 0;
  toggle();
}
static void begin() {
  infraredSampled = sampled;
  takeInfraredTimer();
}
#elif defined(NewPing_h)
static void begin() { NewPing::timer_ms(5, toggle); }
#elif defined(TONE)
static void begin() { tone(OUT_PIN, 1000); }
#elif defined(PWM)
static void begin() { analogWrite(PWM, 100); }
#else
static void begin() { (void)toggle; }
#endif

static void heard(const char *, const char *) {
  digitalWrite(HEARD_PIN, !digitalRead(HEARD_PIN));
  hasHeard = true;
}

void setup() {
  pinMode(OUT_PIN, OUTPUT);
  pinMode(HEARD_PIN, OUTPUT);
  pinMode(BEGUN_PIN, OUTPUT);
#ifdef NEIGHBOUR_FIRST
  begin();
#endif
#ifdef HOSTED
  (void)heard;
  digitalWrite(BEGUN_PIN, board.begin(115200));
#elif defined(RELAYS)
  (void)heard;
  digitalWrite(BEGUN_PIN, relay.begin());
#else
  broadcaster.onHeard(heard);
  digitalWrite(BEGUN_PIN, broadcaster.begin(ADDRESS));
#endif
#ifndef NEIGHBOUR_FIRST
  begin();
#endif
}

void loop() {
#ifdef HOSTED
  board.run();
#elif defined(RELAYS)
  relay.run();
#else
  static uint16_t sent;  // no text twice, as that would be a repeat
  broadcaster.run();
#ifdef ANSWERS
  if (!hasHeard) return;
#else
  if (millis() < static_cast<unsigned long>(sent) * SEND_MILLIS) return;
#endif
  char text[6];
  if (!broadcaster.send(utoa(sent, text, 10))) return;
  sent++;
  hasHeard = false;
#endif
}
