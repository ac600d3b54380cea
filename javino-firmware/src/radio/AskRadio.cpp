#include "AskRadio.h"

#include "AskHardware.h"
#include "../support/Counters.h"

namespace javino {

namespace {

// The line code never holds a level for more than four bits: after twice five bits without an edge there is nothing
// left to wait for.
const uint8_t BITS_TO_ALARM = 5;
const uint8_t SILENCE_ALARMS = 2;

// A carrier is heard from its twelfth bit on, and seen by the loop within 1 ms: another that begins a slot later is
// put off.
const uint16_t SLOT_BITS = 16;

// 0 for a rate that cannot be had: none of ours, or too high for a slow timer.
uint16_t ticksPerBit(uint16_t bitRate) {
  if (bitRate < AskRadio::MIN_BIT_RATE || bitRate > AskRadio::MAX_BIT_RATE) return 0;
  const uint16_t ticks = static_cast<uint16_t>((askhardware::ticksPerSecond() + bitRate / 2) / bitRate);
  return ticks < BitClock::MIN_TICKS ? 0 : ticks;
}

}  // namespace

AskRadio::AskRadio(uint8_t rxPin, uint8_t txPin, uint16_t bitRate)
    : rxPin_(rxPin),
      txPin_(txPin),
      bitRate_(bitRate),
      bitTicks_(ticksPerBit(bitRate)),
      ready_(false),
      sending_(false),
      nextBit_(false),
      lastBitOut_(false),
      alarm_(0),
      silentAlarms_(SILENCE_ALARMS),
      heardUntil_(0),
      level_(false),
      bitClock_(bitTicks_),
      carrier_(bitTicks_),
      decoder_(queue_, carrier_, counters_),
      counters_() {}

bool AskRadio::begin() {
  ready_ = bitTicks_ != 0 && askhardware::begin(rxPin_, txPin_, *this);
  if (ready_) startReceiving();
  return ready_;
}

bool AskRadio::send(const uint8_t *payload, uint8_t length) {
  if (!ready_ || sending_ || length == 0 || length > MAX_RADIO_PAYLOAD || !queue_.claim()) return false;
  {
    askhardware::InterruptLock lock;
    stopReceiving();
  }
  // What is sent lies in the free slot of the queue, as nothing is received meanwhile.
  RadioPacket *packet = queue_.claim();
  const bool room = packet && encoder_.start(payload, length, packet->bytes);
  askhardware::InterruptLock lock;
  if (!room) {  // a packet has come since the first look
    startReceiving();
    return false;
  }
  sending_ = true;
  nextBit_ = encoder_.next();
  lastBitOut_ = false;
  alarm_ = static_cast<uint16_t>(askhardware::now() + bitTicks_);
  askhardware::setAlarm(alarm_);
  return true;
}

bool AskRadio::carrier() const {
  askhardware::InterruptLock lock;
  return carrier_.isHeard();
}

uint16_t AskRadio::airtimeMillis(uint8_t length) const {
  return static_cast<uint16_t>(RadioEncoder::bitsOf(length) * 1000ul / bitRate_);
}

uint8_t AskRadio::slotMillis() const { return static_cast<uint8_t>((SLOT_BITS * 1000u + bitRate_ - 1) / bitRate_); }

uint8_t *AskRadio::receive(uint8_t &length) {
  while (RadioPacket *packet = queue_.oldest()) {
    if (makeWhole(*packet)) {
      length = packet->payloadLength();
      return packet->payload();
    }
    queue_.release();
  }
  return nullptr;
}

// Checks or mends, and counts.
bool AskRadio::makeWhole(RadioPacket &packet) {
  const bool complete = packet.wrongNibble == RadioPacket::NO_NIBBLE;
  if (!(complete ? packet.isIntact() : packet.mend())) {
    count(counters_.damaged);
    return false;
  }
  count(counters_.received);
  if (!complete) count(counters_.mended);
  return true;
}

void AskRadio::count(uint32_t &counter) {
  askhardware::InterruptLock lock;
  countUp(counter);
}

void AskRadio::counters(RadioCounters &into) const {
  askhardware::InterruptLock lock;
  into = counters_;
}

void AskRadio::onEdge(uint16_t now, bool level) {
  if (silentAlarms_ == SILENCE_ALARMS) {
    bitClock_.reset(level);
    heardUntil_ = now;
  } else {
    hear(now);
  }
  if (!decoder_.inPacket()) carrier_.addEdge(now);
  level_ = level;
  silentAlarms_ = 0;
  askhardware::setAlarm(static_cast<uint16_t>(now + BITS_TO_ALARM * bitTicks_));
}

void AskRadio::onAlarm() {
  if (sending_) {
    sendBit();
  } else {
    onSilence();
  }
}

void AskRadio::startReceiving() {
  silentAlarms_ = SILENCE_ALARMS;
  askhardware::watchEdges(true);
}

void AskRadio::stopReceiving() {
  askhardware::watchEdges(false);
  askhardware::clearAlarm();
  carrier_.reset();
  decoder_.abandon();
}

// Gives the decoder the bits of the time since the line was last looked at.
void AskRadio::hear(uint16_t now) {
  uint16_t ticks = static_cast<uint16_t>(now - heardUntil_);
  bool bit;
  while (bitClock_.advance(ticks, level_, bit)) {
    carrier_.addBit();
    decoder_.add(bit);
  }
  heardUntil_ = now;
}

void AskRadio::onSilence() {
  const uint16_t now = askhardware::now();
  hear(now);
  if (silentAlarms_ == 0 || isHeldByCollision()) {
    silentAlarms_ = 1;
    askhardware::setAlarm(static_cast<uint16_t>(now + BITS_TO_ALARM * bitTicks_));
  } else {
    silentAlarms_ = SILENCE_ALARMS;
    askhardware::clearAlarm();
    carrier_.reset();
    decoder_.endOfSignal();
  }
}

// Two packets at once may well fill each other's gaps.
bool AskRadio::isHeldByCollision() const { return level_ && carrier_.isHeard(); }

void AskRadio::sendBit() {
  askhardware::transmit(nextBit_);
  if (lastBitOut_) {
    finishSending();
    return;
  }
  lastBitOut_ = !encoder_.hasNext();
  nextBit_ = encoder_.next();  // off after the last
  alarm_ += bitTicks_;
  askhardware::setAlarm(alarm_);
}

void AskRadio::finishSending() {
  askhardware::clearAlarm();
  countUp(counters_.sent);
  sending_ = false;
  startReceiving();
}

}  // namespace javino
