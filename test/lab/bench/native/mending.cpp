// The gain of mending one symbol, and whether it ever makes a wrong payload: packets of 40 random bytes with random bit
// errors, until a million of them were damaged; a JSON object a rate. Takes half a minute.
#include <cstdio>
#include <cstdlib>

#include "support/Damage.h"

namespace {

const unsigned DAMAGED_AT_EACH_RATE = 250000;

}  // namespace

int main() {
  std::mt19937 random(1);
  for (const char *rate : {"0.0001", "0.001", "0.003", "0.01"}) {
    Damage damage;
    while (damage.damaged() < DAMAGED_AT_EACH_RATE) {
      Bytes payload(40);
      for (uint8_t &byte : payload) byte = static_cast<uint8_t>(random());
      damage.tryPacket(payload, atof(rate), random);
    }
    printf("{\"bitErrorRate\":%s,\"packets\":%u,\"damaged\":%u,\"intact\":%u,\"mended\":%u,\"wrong\":%u}\n", rate,
           damage.packets, damage.damaged(), damage.intact, damage.mended, damage.wrong);
  }
}
