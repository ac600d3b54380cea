#pragma once

#include <string>
#include <vector>

#include "ReferencePacket.h"

// test/vectors/radio.json: packets and refusals to the bit.
struct RadioVector {
  Bytes payload;
  Bits bits;
};

struct InvalidRadioVector {
  std::string why;
  Bits bits;
};

std::vector<RadioVector> radioVectors();
std::vector<InvalidRadioVector> invalidRadioVectors();
