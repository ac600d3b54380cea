#include "SimulatedEeprom.h"

#include <storage/Eeprom.h>

static const uint8_t ERASED = 0xFF;

static SimulatedEeprom *currentEeprom = nullptr;

namespace javinolib {
namespace eeprom {

uint8_t read(uint16_t at) { return currentEeprom->read(at); }
void write(uint16_t at, uint8_t value) { currentEeprom->write(at, value); }

}  // namespace eeprom
}  // namespace javinolib

SimulatedEeprom::SimulatedEeprom() : before_(currentEeprom), random_(1) {
  cells_.fill(0xFF);
  use();
}

SimulatedEeprom::~SimulatedEeprom() {
  if (currentEeprom == this) currentEeprom = before_;
}

void SimulatedEeprom::use() { currentEeprom = this; }

uint8_t SimulatedEeprom::read(uint16_t at) {
  const uint8_t cell = cells_.at(at);
  if (misread_ == at) {
    misread_ = -1;
    return static_cast<uint8_t>(~cell);
  }
  const auto weak = weak_.find(at);
  if (weak == weak_.end()) return cell;
  const uint8_t masks[] = {0x00, 0xFF, random_.byte()};
  const uint8_t mask = masks[random_.number(3)];
  return static_cast<uint8_t>((cell & ~mask) | (weak->second & mask));
}

void SimulatedEeprom::write(uint16_t at, uint8_t value) {
  uint8_t &cell = cells_.at(at);
  if (writesLeft_ == 0) {
    cutIn(at, value);
    throw PowerCut();
  }
  if (writesLeft_ > 0) writesLeft_--;
  writes_++;
  writesOf_[at]++;
  if (worn_[at]) return;
  cell = value;
  weak_.erase(at);
}

void SimulatedEeprom::cutIn(uint16_t at, uint8_t value) {
  uint8_t &cell = cells_.at(at);
  if (!weakly_) {
    cell = garbage_;
    weak_.erase(at);
    return;
  }
  if (random_.number(2) == 0) cell = value;
  weak_[at] = ERASED;
}

void SimulatedEeprom::cutPowerAfter(int writes, uint8_t garbage) {
  writesLeft_ = writes;
  garbage_ = garbage;
  weakly_ = false;
}

void SimulatedEeprom::cutPowerWeaklyAfter(int writes, uint32_t seed) {
  writesLeft_ = writes;
  random_ = RandomBytes(seed * 2654435761u);
  weakly_ = true;
}

int SimulatedEeprom::writesOf(uint16_t at) const {
  const auto found = writesOf_.find(at);
  return found == writesOf_.end() ? 0 : found->second;
}
