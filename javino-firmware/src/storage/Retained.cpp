#include "Retained.h"

#include <stddef.h>

#include "../support/Crc16.h"

namespace javinolib {
namespace retained {

static const uint16_t CANARY = 0xCA9A;

JAVINO_NOINLINE static uint16_t crc() {
  Crc16 crc;
  crc.add(reinterpret_cast<const uint8_t *>(&takenNonces()), offsetof(TakenNonces, check));
  return crc.value();
}

bool hasCanary() { return takenNonces().canary == CANARY; }

bool holds() { return hasCanary() && takenNonces().check == crc() && isClear(); }

void seal() { takenNonces().check = crc(); }

void beginEpoch(uint32_t epoch) {
  takenNonces().epoch = epoch;
  takenNonces().canary = CANARY;
  seal();
}

}  // namespace retained
}  // namespace javinolib
