#include "EepromLayout.h"

#include "Eeprom.h"

namespace javinolib {

// The number of the layout. The two others: the same, but an older one was wiped, or is being wiped. None has all the bits of
// another one, and so is not read in a cell where power failed on the way between 0xFF and that.
static const uint8_t LAYOUT = 0x09;
static const uint8_t LAYOUT_AFTER_WIPING = 0x11;
static const uint8_t WIPING = 4;
static const uint8_t OLDER_LAYOUT = 2;  // and 3
static const uint8_t ERASED = 0xFF;

static bool holdsOlderLayout() {
  uint8_t rfId[RF_ID_RECORD_LENGTH];
  return EepromRecord(0, RF_ID_LENGTH).read(rfId) || EepromRecord(RF_ID_RECORD_LENGTH, RF_ID_LENGTH).read(rfId);
}

// The byte of the number was in no older layout. So where power fails while the rest is wiped, the next boot goes on.
bool beginLayout() {
  uint8_t found = eeprom::read(LAYOUT_AT);
  if (found != LAYOUT && found != LAYOUT_AFTER_WIPING) {
    const bool isOlder = (found >= OLDER_LAYOUT && found <= WIPING) || holdsOlderLayout();
    if (isOlder) {
      eeprom::write(LAYOUT_AT, WIPING);
      for (uint16_t at = 0; at != LAYOUT_AT; at++) {
        if (eeprom::read(at) != ERASED) eeprom::write(at, ERASED);
      }
    }
    found = isOlder ? LAYOUT_AFTER_WIPING : LAYOUT;
    eeprom::write(LAYOUT_AT, found);
  }
  return found == LAYOUT_AFTER_WIPING;
}

}  // namespace javinolib
