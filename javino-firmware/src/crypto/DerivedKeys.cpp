#include "DerivedKeys.h"

#include <string.h>

#include "../support/Flash.h"
#include "../support/Wipe.h"
#include "Cmac.h"

namespace javinolib {

const uint8_t DerivedKeys::CHECK_LENGTH;

namespace {

const uint8_t LABEL_LENGTH = 9;

const uint8_t ENCRYPTION[LABEL_LENGTH] JAVINO_FLASH = {'J', 'a', 'v', 'i', 'n', 'o', 'E', 'n', 'c'};
const uint8_t AUTHENTICATION[LABEL_LENGTH] JAVINO_FLASH = {'J', 'a', 'v', 'i', 'n', 'o', 'M', 'a', 'c'};
const uint8_t CHECK[LABEL_LENGTH] JAVINO_FLASH = {'J', 'a', 'v', 'i', 'n', 'o', 'C', 'h', 'k'};

// One round of the KDF gives all 128 bits: counter 1, label, 0x00, no context, and the length in bits.
void kdf(const Cmac &prf, const uint8_t *label, uint8_t *derived) {
  uint8_t input[1 + LABEL_LENGTH + 1 + 2];
  input[0] = 1;
  for (uint8_t i = 0; i < LABEL_LENGTH; i++) input[1 + i] = flashByte(label + i);
  input[1 + LABEL_LENGTH] = 0;
  input[2 + LABEL_LENGTH] = 0;
  input[3 + LABEL_LENGTH] = 0x80;
  prf.compute(input, sizeof input, derived);
}

}  // namespace

DerivedKeys::~DerivedKeys() { wipe(this, sizeof *this); }

void DerivedKeys::derive(const uint8_t *key) {
  const Aes128 cipher(key);
  const Cmac prf(cipher);
  uint8_t forCheck[Aes128::BLOCK_LENGTH];
  kdf(prf, ENCRYPTION, encryption);
  kdf(prf, AUTHENTICATION, authentication);
  kdf(prf, CHECK, forCheck);
  memcpy(check, forCheck, sizeof check);
  wipe(forCheck, sizeof forCheck);
}

void DerivedKeys::authenticate(const uint8_t *message, uint16_t length, uint8_t *tag) const {
  cmac(Aes128(authentication), message, length, tag);
}

bool DerivedKeys::equals(const DerivedKeys &other) const {
  return equalInConstantTime(encryption, other.encryption, sizeof encryption) &&
         equalInConstantTime(authentication, other.authentication, sizeof authentication);
}

}  // namespace javinolib
