#include "SimulatedRam.h"

#include <cstring>

static SimulatedRam *current = nullptr;

namespace javinolib {
namespace retained {

TakenNonces &takenNonces() { return current->takenNonces; }

bool isClear() { return current->isClear; }

}  // namespace retained
}  // namespace javinolib

SimulatedRam::SimulatedRam() : before_(current), random_(20) {
  losePower();
  use();
}

SimulatedRam::~SimulatedRam() {
  if (current == this) current = before_;
}

void SimulatedRam::use() { current = this; }

void SimulatedRam::losePower() { restore(random_.bytes(sizeof takenNonces)); }

Bytes SimulatedRam::content() const {
  const uint8_t *bytes = reinterpret_cast<const uint8_t *>(&takenNonces);
  return Bytes(bytes, bytes + sizeof takenNonces);
}

void SimulatedRam::restore(const Bytes &content) {
  memcpy(static_cast<void *>(&takenNonces), content.data(), sizeof takenNonces);
}
