#include "SimulatedEeprom.h"

#include <storage/Eeprom.h>

static SimulatedEeprom *current = nullptr;

namespace javino {
namespace eeprom {

uint8_t read(uint16_t at) { return current->read(at); }
void update(uint16_t at, uint8_t value) { current->update(at, value); }

}  // namespace eeprom
}  // namespace javino

SimulatedEeprom::SimulatedEeprom() : before_(current) {
  cells_.fill(0xFF);
  use();
}

SimulatedEeprom::~SimulatedEeprom() {
  if (current == this) current = before_;
}

void SimulatedEeprom::use() { current = this; }

void SimulatedEeprom::update(uint16_t at, uint8_t value) {
  uint8_t &cell = cells_.at(at);
  if (cell == value) return;
  if (writesLeft_ == 0) {
    cell = garbage_;
    throw PowerCut();
  }
  if (writesLeft_ > 0) writesLeft_--;
  writes_++;
  writesOf_[at]++;
  if (!worn_[at]) cell = value;
}

void SimulatedEeprom::cutPowerAfter(int writes, uint8_t garbage) {
  writesLeft_ = writes;
  garbage_ = garbage;
}

int SimulatedEeprom::writesOf(uint16_t at) const {
  const auto found = writesOf_.find(at);
  return found == writesOf_.end() ? 0 : found->second;
}
