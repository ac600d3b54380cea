#include "AskRadio.h"

#include "AskHardware.h"
#include "../support/Counters.h"

namespace javinolib {

namespace {

// The line code never holds a level for more than four bits: after twice five bits without an edge there is nothing
// left to wait for.
const uint8_t BITS_TO_ALARM = 5;
const uint8_t ALARMS_TO_SILENCE = 2;

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
      bitClock_(bitTicks_),
      decoder_(bitTicks_) {}

bool AskRadio::begin() {
  ready_ = askhardware::begin(rxPin_, txPin_, *this) && bitTicks_ != 0;
  if (ready_) startReceiving();
  return ready_;
}

bool AskRadio::send(const uint8_t *payload, uint8_t length) {
  if (!ready_ || sending_ || length == 0 || length > MAX_RADIO_PAYLOAD) return false;
  RadioPacket *packet;
  {
    askhardware::InterruptLock lock;
    packet = decoder_->queue().claim();
    if (packet) stopReceiving();
  }
  // A packet that is sent lies in the free slot of the queue, as nothing is received meanwhile.
  if (!packet) return false;
  encoder_->start(payload, length, follower_, packet->room, path_);
  askhardware::InterruptLock lock;
  sending_ = true;
  encoder_->next();  // the first bit is a 0, as is the silence now
  nextBit_ = encoder_->next();
  lastBitOut_ = false;
  // Soon, but not so soon that the alarm could be missed, nor before the point that declares the packet, at 8 MHz too.
  setAlarm(static_cast<uint16_t>(askhardware::now() + bitTicks_ / 2));
  return true;
}

#if JAVINO_LARGE
uint8_t AskRadio::follow(Trailer trailer, uint8_t length) {
  follower_ = trailer;
  return RadioEncoder::trailerLength(trailer, static_cast<uint8_t>(length + linecode::PACKET_OVERHEAD));
}
#endif

bool AskRadio::carrier() const {
  askhardware::InterruptLock lock;
  const bool before = carrierHeard_;
  carrierHeard_ = decoder_->carrier().isHeard();
  return before || carrierHeard_;
}

uint16_t AskRadio::airtimeMillis(uint8_t length) const {
  return static_cast<uint16_t>(RadioEncoder::bitsOf(length) * 1000ul / bitRate_);
}

uint8_t AskRadio::slotMillis() const { return static_cast<uint8_t>((SLOT_BITS * 1000u + bitRate_ - 1) / bitRate_); }

// A packet that is lost waits for release(), or for the next call.
uint8_t *AskRadio::receive(Received &with) {
  lookAtLine();
  if (config::LARGE) mender_->setLastTrailer(decoder_->trailer());
  if (mender_->lost()) release();
  RadioPacket *packet = decoder_->queue().oldest();
  if (!packet) return nullptr;
  if (mender_->step(*packet) != Mender::WHOLE) return nullptr;
  with.path = mender_->path();
  with.length = packet->payloadLength();
  return packet->payload();
}

void AskRadio::release() {
  count(mender_->lost() ? decoder_->counters().damaged : decoder_->counters().received);
  if (!mender_->lost() && mender_->hasMended()) count(decoder_->counters().mended);
  mender_->begin();
  decoder_->queue().release();
}

// A packet whose last bits are alike ends without an edge: it need not wait for the alarm. A level that came in shorter
// parts would not steer the bit clock.
void AskRadio::lookAtLine() {
  askhardware::InterruptLock lock;
  if (decoder_->inPacket()) hear(askhardware::now(), bitTicks_);
}

void AskRadio::count(config::Count &counter) {
  askhardware::InterruptLock lock;
  countUp(counter);
}

void AskRadio::counters(RadioCounters &into) const {
  askhardware::InterruptLock lock;
  into = decoder_->counters();
  const uint32_t late = late_ * 1000ul / (askhardware::ticksPerSecond() / 1000);
  const config::Count most = static_cast<config::Count>(~0ul);
  into.lateMicros = late < most ? static_cast<config::Count>(late) : most;
}

void AskRadio::onEdge(uint16_t now, bool level) {
  if (alarmsLeft_ == 0) {
    bitClock_->reset(level);
    heardUntil_ = now;
  } else {
    hear(now);
  }
  if (!decoder_->inPacket()) decoder_->carrier().addEdge(now, level);
  level_ = level;
  alarmsLeft_ = ALARMS_TO_SILENCE;
  setAlarm(static_cast<uint16_t>(now + BITS_TO_ALARM * bitTicks_));
}

void AskRadio::setAlarm(uint16_t at) {
  alarm_ = at;
  askhardware::setAlarm(at);
}

void AskRadio::onAlarm() {
  const uint16_t late = static_cast<uint16_t>(askhardware::now() - alarm_);
  if (late > late_) late_ = late;
  if (sending_) {
    sendBit();
  } else {
    onSilence();
  }
}

void AskRadio::startReceiving() {
  alarmsLeft_ = 0;
  askhardware::watchEdges(true);
}

void AskRadio::stopReceiving() {
  askhardware::watchEdges(false);
  askhardware::clearAlarm();
  decoder_->carrier().reset();
  decoder_->abandon();
}

// Gives the decoder the bits of the time since the line was last looked at, if that is long enough.
void AskRadio::hear(uint16_t now, uint16_t least) {
  if (decoder_->carrier().isHeard()) carrierHeard_ = true;
  uint16_t ticks = static_cast<uint16_t>(now - heardUntil_);
  if (ticks < least) return;
  bool bit;
  while (bitClock_->advance(ticks, level_, bit)) {
    decoder_->carrier().addBit();
    decoder_->add(bit);
  }
  heardUntil_ = now;
}

void AskRadio::onSilence() {
  const uint16_t now = askhardware::now();
  hear(now);
  if (level_) decoder_->carrier().addHold();
  if (alarmsLeft_ == ALARMS_TO_SILENCE || isHeldByCollision()) {
    alarmsLeft_ = 1;
    setAlarm(static_cast<uint16_t>(now + BITS_TO_ALARM * bitTicks_));
  } else {
    alarmsLeft_ = 0;
    askhardware::clearAlarm();
    decoder_->carrier().silence(level_);
    decoder_->endOfSignal();
  }
}

// Two packets at once may well fill each other's gaps.
bool AskRadio::isHeldByCollision() const { return level_ && decoder_->carrier().isHeard(); }

void AskRadio::sendBit() {
  askhardware::transmit(nextBit_);
  if (lastBitOut_) {
    finishSending();
    return;
  }
  lastBitOut_ = !encoder_->hasNext();
  nextBit_ = encoder_->next();  // off after the last
  setAlarm(static_cast<uint16_t>(alarm_ + bitTicks_));
}

void AskRadio::finishSending() {
  askhardware::clearAlarm();
  countUp(decoder_->counters().sent);
  sending_ = false;
  startReceiving();
}

}  // namespace javinolib
