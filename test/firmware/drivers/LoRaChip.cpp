#include "LoRaChip.h"

#include <algorithm>
#include <cmath>

namespace {

// Its registers.
const uint8_t FIFO = 0x00, OP_MODE = 0x01, FIFO_AT = 0x0D, TX_BASE = 0x0E, RX_BASE = 0x0F, RX_AT = 0x10, IRQ = 0x12,
              RX_BYTES = 0x13, HOP_CHANNEL = 0x1C, CONFIG_1 = 0x1D, CONFIG_2 = 0x1E, PREAMBLE_LSB = 0x21, LENGTH = 0x22,
              CONFIG_3 = 0x26, DIO_MAPPING = 0x40, VERSION = 0x42;

// What it tells.
const uint8_t RX_DONE = 0x40, CRC_ERROR = 0x20, VALID_HEADER = 0x10, TX_DONE = 0x08, CAD_DONE = 0x04,
              CAD_DETECTED = 0x01;

const double BANDWIDTHS[] = {7.8e3, 10.4e3, 15.6e3, 20.8e3, 31.25e3, 41.7e3, 62.5e3, 125e3, 250e3, 500e3};

}  // namespace

void LoRaAir::pass(uint32_t millis) {
  for (uint64_t end = micros + 1000ull * millis; micros < end;) {
    micros += 250;
    for (LoRaChip *chip : chips) chip->update();
    packets_.erase(
        std::remove_if(packets_.begin(), packets_.end(), [this](Packet &packet) { return packet.ends < micros; }),
        packets_.end());
  }
}

void LoRaAir::send(const LoRaChip *from, uint64_t symbol, uint64_t untilHeader, uint64_t length, const Bytes &bytes) {
  const bool collides = !packets_.empty();
  if (collides) collisions++;
  for (Packet &packet : packets_) packet.damaged = true;
  packets_.push_back({from, micros, micros + untilHeader, micros + length, symbol, bytes, collides || lost != 0});
  if (lost != 0) lost--;
  past.push_back(packets_.back());
}

LoRaAir::Packet *LoRaAir::heardBy(const LoRaChip *chip) {
  for (Packet &packet : packets_) {
    if (packet.from != chip && reaches(packet.from, chip)) return &packet;
  }
  return nullptr;
}

LoRaChip::LoRaChip(LoRaAir &air) : RadioLibHal(0, 1, 0, 1, 1, 2), air_(air) {
  connect(&pins_[EMULATED_RADIO_NSS_PIN], &pins_[EMULATED_RADIO_IRQ_PIN], &pins_[EMULATED_RADIO_RST_PIN],
          &pins_[EMULATED_RADIO_GPIO_PIN]);
  registers_[VERSION] = 0x12;
  registers_[PREAMBLE_LSB] = 8;
  air.chips.push_back(this);
}

void LoRaChip::digitalWrite(uint32_t pin, uint32_t value) {
  pins_[pin].value = value;
  if (pin == EMULATED_RADIO_NSS_PIN) HandleGPIO();
}

void LoRaChip::HandleGPIO() { at_ = -1; }

void LoRaChip::spiTransfer(uint8_t *out, size_t length, uint8_t *in) {
  for (size_t i = 0; i < length; i++) in[i] = HandleSPI(out[i]);
}

uint8_t LoRaChip::HandleSPI(uint8_t byte) {
  if (at_ < 0) {
    at_ = byte & 0x7F;
    writes_ = (byte & 0x80) != 0;
    return EMULATED_RADIO_SPI_RETURN;
  }
  const uint8_t was = at_ == FIFO ? fifo_[registers_[FIFO_AT]] : registers_[at_];
  if (writes_) write(byte);
  if (at_ == FIFO) {
    registers_[FIFO_AT]++;
  } else {
    at_++;
  }
  return was;
}

void LoRaChip::write(uint8_t byte) {
  switch (at_) {
    case FIFO: fifo_[registers_[FIFO_AT]] = byte; break;
    case IRQ: registers_[IRQ] = static_cast<uint8_t>(registers_[IRQ] & ~byte); break;
    case VERSION: break;
    case OP_MODE: {
      const Mode before = mode();
      registers_[OP_MODE] = byte;
      if (mode() != before) setMode(mode());
      break;
    }
    default: registers_[at_] = byte;
  }
  updatePin();
}

double LoRaChip::symbolMicros() const {
  return 1e6 * (1 << (registers_[CONFIG_2] >> 4)) / BANDWIDTHS[registers_[CONFIG_1] >> 4];
}

// As its data sheet has it.
double LoRaChip::symbolsOf(size_t length) const {
  const int spreading = registers_[CONFIG_2] >> 4;
  const int crc = (registers_[CONFIG_2] & 4) != 0;
  const int optimized = (registers_[CONFIG_3] & 8) != 0;
  const int coding = 4 + (registers_[CONFIG_1] >> 1 & 7);
  const double groups = std::ceil((8.0 * static_cast<double>(length) - 4 * spreading + 28 + 16 * crc) /
                                  (4 * (spreading - 2 * optimized)));
  return registers_[PREAMBLE_LSB] + 4.25 + 8 + std::max(groups * coding, 0.0);
}

void LoRaChip::setMode(Mode mode) {
  since_ = air_.micros;
  if (mode == TRANSMITS) {
    const uint8_t *const begin = fifo_ + registers_[TX_BASE];
    const uint64_t micros = static_cast<uint64_t>(symbolMicros() * symbolsOf(registers_[LENGTH]));
    until_ = since_ + micros;
    air_.send(this, static_cast<uint64_t>(symbolMicros()),
              static_cast<uint64_t>(symbolMicros() * (registers_[PREAMBLE_LSB] + 12.25)), micros,
              Bytes(begin, begin + registers_[LENGTH]));
  } else if (mode == SCANS) {
    scans++;
    until_ = since_ + static_cast<uint64_t>(2 * symbolMicros());
  }
}

void LoRaChip::update() {
  const LoRaAir::Packet *const packet = air_.heardBy(this);
  if (mode() == TRANSMITS && air_.micros >= until_) {
    registers_[OP_MODE] = static_cast<uint8_t>((registers_[OP_MODE] & ~7) | STANDBY);
    raise(TX_DONE);
  } else if (mode() == SCANS && air_.micros >= until_) {
    registers_[OP_MODE] = static_cast<uint8_t>((registers_[OP_MODE] & ~7) | STANDBY);
    raise(packet && air_.micros < packet->begun + 12 * packet->symbol ? CAD_DONE | CAD_DETECTED : CAD_DONE);
  } else if (mode() == LISTENS && packet && since_ < packet->begun + 6 * packet->symbol) {
    if (air_.micros >= packet->hasHeader) raise(VALID_HEADER);
    if (air_.micros < packet->ends || (registers_[IRQ] & RX_DONE) != 0) return;
    registers_[RX_AT] = registers_[RX_BASE];
    registers_[RX_BYTES] = static_cast<uint8_t>(packet->bytes.size());
    registers_[HOP_CHANNEL] = 0x40;  // it has a CRC
    std::copy(packet->bytes.begin(), packet->bytes.end(), fifo_ + registers_[RX_AT]);
    since_ = air_.micros;
    raise(packet->damaged ? RX_DONE | CRC_ERROR : RX_DONE);
  }
}

void LoRaChip::raise(uint8_t flag) {
  registers_[IRQ] = static_cast<uint8_t>(registers_[IRQ] | flag);
  updatePin();
}

void LoRaChip::updatePin() {
  const uint8_t flags[] = {RX_DONE, TX_DONE, CAD_DONE, 0};
  const uint32_t level = (registers_[IRQ] & flags[registers_[DIO_MAPPING] >> 6]) != 0;
  const bool rises = level != 0 && irq->value == 0;
  irq->value = level;
  if (rises && interrupts && interrupt_) interrupt_();
}
