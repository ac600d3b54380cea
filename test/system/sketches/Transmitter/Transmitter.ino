// A radio transmitter that shares no line with the library JavinoBDI: it sends whatever bytes it is given over serial
// in VirtualWire's line code, made bit by bit in a loop. Tests use it as the neighbour with another program, and as
// the attacker. Serial, 115200 baud: one byte n (1...80), one byte t (0...17), then n bytes (count, payload, CRC as they
// shall be on the air) and t bytes of a trailer; it answers 'k' when they have been sent. Transmitter on pin 12.

const uint8_t kTransmitPin = 12;
const uint16_t kBitMicros = 500;

const uint8_t kSymbols[16] = {0x0d, 0x0e, 0x13, 0x15, 0x16, 0x19, 0x1a, 0x1c,
                              0x23, 0x25, 0x26, 0x29, 0x2a, 0x2c, 0x32, 0x34};

const uint8_t kTrailerSymbols[16] = {0x0d, 0x0e, 0x13, 0x15, 0x07, 0x19, 0x1a, 0x1c,
                                     0x23, 0x25, 0x26, 0x29, 0x2a, 0x2c, 0x32, 0x34};

uint32_t nextBit;

void sendSymbol(uint8_t symbol) {
  for (uint8_t bit = 0; bit < 6; ++bit) {
    while (int32_t(micros() - nextBit) < 0) {
    }
    digitalWrite(kTransmitPin, symbol >> bit & 1);
    nextBit += kBitMicros;
  }
}

void sendBytes(const uint8_t *bytes, uint8_t length, const uint8_t *symbols) {
  for (uint8_t i = 0; i < length; ++i) {
    sendSymbol(symbols[bytes[i] >> 4]);
    sendSymbol(symbols[bytes[i] & 15]);
  }
}

void sendPacket(const uint8_t *bytes, uint8_t length, uint8_t trailerLength) {
  nextBit = micros() + kBitMicros;
  for (uint8_t i = 0; i < 6; ++i) sendSymbol(0x2a);
  sendSymbol(0x38);
  sendSymbol(0x2c);
  sendBytes(bytes, length, kSymbols);
  sendBytes(bytes + length, trailerLength, kTrailerSymbols);
  while (int32_t(micros() - nextBit) < 0) {
  }
  digitalWrite(kTransmitPin, LOW);
}

uint8_t readByte() {
  while (!Serial.available()) {
  }
  return Serial.read();
}

void setup() {
  pinMode(kTransmitPin, OUTPUT);
  Serial.begin(115200);
}

void loop() {
  uint8_t bytes[80 + 17];
  const uint8_t length = readByte();
  const uint8_t trailerLength = readByte();
  if (length == 0 || length > 80 || trailerLength > 17) return;
  for (uint8_t i = 0; i < length + trailerLength; ++i) bytes[i] = readByte();
  sendPacket(bytes, length, trailerLength);
  Serial.write('k');
}
