#include "Wipe.h"

namespace javino {

void wipe(void *secret, size_t length) {
  volatile uint8_t *byte = static_cast<volatile uint8_t *>(secret);
  while (length-- > 0) *byte++ = 0;
}

}  // namespace javino
