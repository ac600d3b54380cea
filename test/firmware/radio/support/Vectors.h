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

struct CopyVector {
  Bytes payload;
  uint8_t path;
  Bits bits;
};

struct TrailerVector {
  Bytes payload, trailer;
  Bits bits;  // of the packet and the trailer
};

std::vector<RadioVector> radioVectors();
std::vector<InvalidRadioVector> invalidRadioVectors();
std::vector<CopyVector> copyVectors();
std::vector<TrailerVector> trailerVectors();

// test/vectors/parity.json.
struct ParityVector {
  Bytes bytes, parity;
};

struct DamagedVector {
  Bytes received, erasures, codeword;
};

std::vector<ParityVector> parityVectors();
std::vector<DamagedVector> damagedVectors();
