#include "Delivery.h"

#include "../storage/EepromLayout.h"

namespace javino {

static EepromRecord relaying() { return EepromRecord(RELAYING_AT, RELAYING_LENGTH); }

bool Delivery::begin() {
  seed();
  courier_.begin();
  uint8_t stored;
  if (config::RELAY) receiver_.forwarding().relay(relaying().begin(&stored, 0) && medium_.canRelay());
  return medium_.begin();
}

bool Delivery::relay(bool on) {
  const uint8_t stored = 1;
  if (on == relays()) return true;
  if (on ? !relaying().write(&stored) : !relaying().erase(0)) return false;
  receiver_.forwarding().relay(on);
  return true;
}

// What came first, since an acknowledgement may end what would else be sent again; then our own acknowledgements.
void Delivery::run() {
  medium_.update();
  receiver_.run();
  acknowledger_.run();
  receiver_.forwarding().run();
  courier_.run();
}

void Delivery::keysChanged() {
  inbox_.keysChanged(state_.keys);
  acknowledger_.keysChanged();
  courier_.keysChanged();
}

}  // namespace javino
