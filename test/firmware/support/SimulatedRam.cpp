#include "SimulatedRam.h"

#include <cstring>

static SimulatedRam *currentRam = nullptr;

namespace javinolib {
namespace retained {

TakenNonces &takenNonces() { return currentRam->takenNonces; }

Airtime &airtime() { return currentRam->airtime; }

bool isClear() { return currentRam->isClear; }

}  // namespace retained
}  // namespace javinolib

SimulatedRam::SimulatedRam() : before_(currentRam), random_(20) {
  losePower();
  use();
}

SimulatedRam::~SimulatedRam() {
  if (currentRam == this) currentRam = before_;
}

void SimulatedRam::use() { currentRam = this; }

void SimulatedRam::losePower() {
  restore(random_.bytes(sizeof takenNonces));
  memcpy(&airtime, random_.bytes(sizeof airtime).data(), sizeof airtime);
}

Bytes SimulatedRam::content() const {
  const uint8_t *bytes = reinterpret_cast<const uint8_t *>(&takenNonces);
  return Bytes(bytes, bytes + sizeof takenNonces);
}

void SimulatedRam::restore(const Bytes &content) {
  memcpy(static_cast<void *>(&takenNonces), content.data(), sizeof takenNonces);
}
