#include "ReplayRig.h"

using javinolib::ReplayMemory;

ReplayRig::ReplayRig() {
  keys.begin();
  for (uint8_t i = 0; i < KEYS; i++) keys.set(javinolib::Address(i), Bytes(16, i).data());
  reset();
}

void ReplayRig::reset() {
  epoch++;
  keys.begin();
  memory.reset(new ReplayMemory(keys));
  memory->begin(epoch);
}

void ReplayRig::powerCycle() {
  ram.losePower();
  reset();
}

bool ReplayRig::take(uint8_t key, const javinolib::Address &origin, const Bytes &nonce) {
  if (judge(key, origin, nonce) != ReplayMemory::NEWER || !reserve(key, origin, nonce)) return false;
  memory->remember(key, origin, nonce.data());
  return true;
}

Bytes ReplayRig::floor(uint8_t key, const javinolib::Address &origin) const {
  Bytes floor(javinolib::NONCE_LENGTH);
  memory->floor(key, origin, floor.data());
  return floor;
}
