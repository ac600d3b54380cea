#include "Aes128.h"

#include "../support/Wipe.h"

namespace javinolib {

const uint8_t Aes128::BLOCK_LENGTH;
const uint8_t Aes128::KEY_LENGTH;

Aes128::~Aes128() { wipe(roundKeys_, sizeof roundKeys_); }

}  // namespace javinolib
