#include "SerialRadio.h"

#include <string.h>

#include "../support/Clock.h"
#include "../support/Counters.h"

namespace javinolib {

const uint8_t SerialRadio::NO_PIN;
const uint8_t SerialRadio::ROOM;

namespace {

// 0x00, COBS, path, CRC and 0x00 around a payload.
const uint8_t OVERHEAD = 6;

// A packet whose next byte does not come within this time has lost its end.
const uint16_t GAP_MILLIS = 40;

// The bytes that fit into the core's buffer for a UART: one less than its size.
#ifdef SERIAL_RX_BUFFER_SIZE
const int PORT_ROOM = SERIAL_RX_BUFFER_SIZE - 1;
#else
const int PORT_ROOM = 63;
#endif

uint16_t now() { return static_cast<uint16_t>(clock::millis()); }

}  // namespace

SerialRadio::SerialRadio(Stream &port, void (*begin)(Stream &, unsigned long), int (*room)(Stream &),
                         const SerialModule &module, uint8_t auxPin)
    : port_(port),
      beginPort_(begin),
      roomOfPort_(room),
      module_(module),
      auxPin_(auxPin),
      decoder_(in_, static_cast<uint16_t>(1 + flashByte(&module.longestPayload) + 2)) {}

bool SerialRadio::begin() {
  beginPort_(port_, flashWord(&module_.baud));
  if (auxPin_ != NO_PIN) pinMode(auxPin_, INPUT_PULLUP);
  return canWrite();
}

bool SerialRadio::send(const uint8_t *payload, uint8_t length) {
  if (sending_ || isBusy() || length == 0 || length > longestPayload() || !canWrite()) return false;
  out_[0] = sentPath_;
  memcpy(out_ + 1, payload, length);
  encoder_.start(out_, static_cast<uint16_t>(1 + length));
  port_.write(static_cast<uint8_t>(0));
  sending_ = true;
  airtime_ = airtimeMillis(length);
  sentAt_ = now();
  write();
  return true;
}

bool SerialRadio::carrier() const {
  const bool before = heard_;
  heard_ = inPacket_ || port_.available() > 0 || (isBusy() && !sending_);
  return before || heard_;
}

uint16_t SerialRadio::airtimeMillis(uint8_t length) const {
  const uint32_t micros = static_cast<uint32_t>(length + OVERHEAD) * flashWord(&module_.airtimeMicros);
  return static_cast<uint16_t>(flashWord(&module_.airtimeMillis) + micros / 1000);
}

uint8_t *SerialRadio::receive(Received &with) {
  write();
  read();
  if (!waits_) return nullptr;
  with.length = static_cast<uint8_t>(decoder_.frameLength());
  with.path = decoder_.sequence();
  return in_ + 1;
}

bool SerialRadio::idle() const { return !waits_ && port_.available() <= 0 && (encoder_.done() || !canWrite()); }

// A module pulls its AUX low while it starts, sends, or gives what it has received.
bool SerialRadio::isBusy() const { return auxPin_ != NO_PIN && digitalRead(auxPin_) == LOW; }

void SerialRadio::write() {
  while (!encoder_.done() && canWrite()) port_.write(encoder_.next());
  if (!sending_ || !encoder_.done() || static_cast<uint16_t>(now() - sentAt_) < airtime_) return;
  sending_ = false;
  countUp(counters_.sent);
}

// While a packet waits, the next bytes wait in the port.
void SerialRadio::read() {
  if (port_.available() >= PORT_ROOM) overrun_ = true;
  while (!waits_ && port_.available() > 0) take(static_cast<uint8_t>(port_.read()));
  if (static_cast<uint16_t>(now() - heardAt_) >= GAP_MILLIS) inPacket_ = false;
}

void SerialRadio::take(uint8_t byte) {
  heard_ = true;
  inPacket_ = byte != 0;
  heardAt_ = now();
  const PacketEvent event = decoder_.add(byte);
  if (event == PacketEvent::NONE) return;
  waits_ = event == PacketEvent::PACKET && decoder_.sequence() < PATHS;
  if (waits_) {
    countUp(counters_.received);
  } else {
    countUp(overrun_ ? counters_.missed : counters_.damaged);
    overrun_ = false;
  }
}

}  // namespace javinolib
