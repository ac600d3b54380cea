// The reference for Modem: the same task done as VirtualWire does it, written anew from its description. A timer
// interrupts eight times a bit, whether anything is on the air or not. The receiver advances a ramp of 160 steps by 20 a
// sample, or by 11 or 29 where the line changed; five samples or more make a one. The sender puts a bit out at each
// eighth interrupt. Pins are read and written with the core's functions.

#include <avr/eeprom.h>
#include <avr/sleep.h>
#include <util/crc16.h>

const uint8_t SENDER_PIN = 40;
const uint8_t RX_PIN = 11;
const uint8_t TX_PIN = 12;
uint16_t *const RATE_PLACE = reinterpret_cast<uint16_t *>(4094);

const uint8_t LENGTH = 77;
const uint8_t COUNT = LENGTH + 3;
const uint8_t HEADER_SYMBOLS = 8;
const uint8_t SAMPLES = 8;
const uint8_t RAMP_LENGTH = 160;
const uint16_t START = 0xB38;

const uint8_t SYMBOLS[16] = {0x0D, 0x0E, 0x13, 0x15, 0x16, 0x19, 0x1A, 0x1C,
                             0x23, 0x25, 0x26, 0x29, 0x2A, 0x2C, 0x32, 0x34};

// Sending: all symbols of a packet, made ahead.
uint8_t out[HEADER_SYMBOLS + 2 * COUNT] = {0x2A, 0x2A, 0x2A, 0x2A, 0x2A, 0x2A, 0x38, 0x2C};
volatile bool sending = false;
uint8_t outIndex, outBit, outSample;

// Receiving.
bool isSender;
bool lastSample;
uint8_t ramp, ones;
uint16_t bits;
volatile bool done = false;
bool active = false;
uint8_t bitCount, inLength;
uint8_t in[COUNT];

void sendSample() {
  if (outSample++ == 0) {
    if (outIndex >= sizeof out) {
      sending = false;
      digitalWrite(TX_PIN, LOW);
    } else {
      digitalWrite(TX_PIN, out[outIndex] & 1 << outBit++);
      if (outBit >= 6) {
        outBit = 0;
        outIndex++;
      }
    }
  }
  if (outSample >= SAMPLES) outSample = 0;
}

uint8_t nibbleOf(uint8_t symbol) {
  for (uint8_t i = symbol >> 2 & 8, end = i + 8; i < end; i++)
    if (SYMBOLS[i] == symbol) return i;
  return 0;
}

void addBit() {
  bits >>= 1;
  if (ones >= 5) bits |= 0x800;
  ones = 0;
  if (active) {
    if (++bitCount < 12) return;
    bitCount = 0;
    const uint8_t byte = nibbleOf(bits & 0x3F) << 4 | nibbleOf(bits >> 6);
    if (inLength == 0 && byte != COUNT) {
      active = false;
      return;
    }
    in[inLength++] = byte;
    if (inLength == COUNT) {
      active = false;
      done = true;
    }
  } else if (bits == START && !done) {
    active = true;
    bitCount = 0;
    inLength = 0;
  }
}

void receiveSample(bool sample) {
  if (sample) ones++;
  if (sample != lastSample) {
    ramp += ramp < RAMP_LENGTH / 2 ? 11 : 29;
    lastSample = sample;
  } else {
    ramp += 20;
  }
  if (ramp >= RAMP_LENGTH) {
    ramp -= RAMP_LENGTH;
    addBit();
  }
}

ISR(TIMER1_COMPA_vect) {
  if (sending) {
    sendSample();
  } else if (!isSender) {
    receiveSample(digitalRead(RX_PIN));
  }
}

uint16_t crcOf(const uint8_t *bytes, uint8_t length) {
  uint16_t crc = 0xFFFF;
  while (length--) crc = _crc_ccitt_update(crc, *bytes++);
  return crc;
}

void sendNext() {
  static uint32_t state = 1;
  uint8_t packet[COUNT] = {COUNT};
  for (uint8_t i = 1; i <= LENGTH; i++) {
    state = state * 1664525 + 1013904223;
    packet[i] = state >> 24;
  }
  const uint16_t crc = ~crcOf(packet, LENGTH + 1);
  packet[LENGTH + 1] = crc;
  packet[LENGTH + 2] = crc >> 8;
  uint8_t *symbol = out + HEADER_SYMBOLS;
  for (uint8_t i = 0; i < COUNT; i++) {
    *symbol++ = SYMBOLS[packet[i] >> 4];
    *symbol++ = SYMBOLS[packet[i] & 15];
  }
  outIndex = outBit = outSample = 0;
  sending = true;
}

void receiveNext() {
  static uint16_t received = 0;
  if (crcOf(in, COUNT) == 0xF0B8) Serial.println(++received);
  done = false;
}

void setup() {
  Serial.begin(115200);
  pinMode(TX_PIN, OUTPUT);
  isSender = digitalRead(SENDER_PIN);
  const uint16_t stored = eeprom_read_word(RATE_PLACE);
  const uint16_t bitRate = stored == 0xFFFF ? 2000 : stored;
  TCCR1A = 0;
  TCCR1B = _BV(WGM12) | _BV(CS10);
  OCR1A = F_CPU / SAMPLES / bitRate - 1;
  TIMSK1 = _BV(OCIE1A);
}

void loop() {
  if (isSender && !sending) sendNext();
  if (done) receiveNext();
  set_sleep_mode(SLEEP_MODE_IDLE);
  sleep_mode();
}
