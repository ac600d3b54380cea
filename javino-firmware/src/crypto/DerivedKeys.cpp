#include "DerivedKeys.h"

#include <string.h>

#include "../support/Flash.h"
#include "../support/Wipe.h"
#include "Cmac.h"

namespace javinolib {

const uint8_t DerivedKeys::CHECK_LENGTH;

namespace {

// One round of the KDF gives all 128 bits: counter 1, label, 0x00, no context, and the length in bits.
const uint8_t INPUT_LENGTH = 13;
const uint8_t NAME_AT = 7;  // the label's last three letters
const uint8_t NAME_LENGTH = 3;
const uint8_t KDF_INPUT[INPUT_LENGTH] JAVINO_FLASH = {1, 'J', 'a', 'v', 'i', 'n', 'o', 0, 0, 0, 0, 0, 0x80};
const uint8_t NAMES[] JAVINO_FLASH = {'C', 'h', 'k', 'E', 'n', 'c', 'M', 'a', 'c'};

}  // namespace

DerivedKeys::~DerivedKeys() { wipe(this, sizeof *this); }

// The first tag gives the check value, and is written over but for its beginning.
void DerivedKeys::derive(const uint8_t *key) {
  const Aes128 cipher(key);
  const Cmac prf(cipher);
  uint8_t input[INPUT_LENGTH];
  for (uint8_t i = 0; i != INPUT_LENGTH; i++) input[i] = flashByte(KDF_INPUT + i);
  const uint8_t *name = NAMES;
  for (uint8_t *into = check; name != NAMES + sizeof NAMES; into += into == check ? CHECK_LENGTH : Aes128::KEY_LENGTH) {
    for (uint8_t i = 0; i != NAME_LENGTH; i++) input[NAME_AT + i] = flashByte(name++);
    prf.compute(input, INPUT_LENGTH, into);
  }
}

void DerivedKeys::authenticate(const uint8_t *message, uint16_t length, uint8_t *tag) const {
  cmac(Aes128(authentication), message, length, tag);
}

bool DerivedKeys::equals(const DerivedKeys &other) const {
  return equalInConstantTime(check, other.check, sizeof *this);
}

}  // namespace javinolib
