#include "Delivery.h"

#include <string.h>

#include "../storage/EepromLayout.h"

namespace javinolib {

static EepromRecord relaying() { return EepromRecord(RELAYING_AT, RELAYING_LENGTH); }

bool Delivery::begin() {
  seed();
  retransmitter_->begin();
  uint8_t number[RELAYING_LENGTH + EepromRecord::CHECK_LENGTH];
  if (config::LARGE && relaying().begin(number, 0) && medium_->canRelay()) beginToRelay(number);
  const bool begun = medium_->begin();
  receiver_.begin();
  return begun;
}

void Delivery::seed() { state_->random->seed(state_->id.address().value(), state_->epoch.value()); }

bool Delivery::relay(const uint8_t *number) {
  if ((number != nullptr) == relays()) return true;
  if (number == nullptr) {
    if (!relaying().erase(0)) return false;
    receiver_.relay(false);
    return true;
  }
  uint8_t record[RELAYING_LENGTH + EepromRecord::CHECK_LENGTH];
  memcpy(record, number, RELAYING_LENGTH);
  if (!relaying().write(record)) return false;
  beginToRelay(number);
  return true;
}

// Two relays with the same random numbers would send at the same time, again and again.
void Delivery::beginToRelay(const uint8_t *number) {
  if (!state_->id.isSet()) {
    state_->random->seed(static_cast<uint16_t>(number[0] << 8 | number[1]), state_->epoch.value());
  }
  receiver_.relay(true);
}

// Packets that came are handled first, since an acknowledgement may end what would else be sent again; then our own
// acknowledgements are sent.
template <typename Scope>
void Delivery::run() {
  medium_->update();
  receiver_.run<Scope>();
  acknowledger_->run();
  receiver_.forwarding().run();
  retransmitter_->run<Scope>();
}

template void Delivery::run<WholeScope>();
template void Delivery::run<UnicastScope>();

template <typename Scope>
void Delivery::keysChanged() {
  inbox_->keysChanged(state_->keys);
  acknowledger_->keysChanged();
  retransmitter_->keysChanged<Scope>();
}

template void Delivery::keysChanged<WholeScope>();
template void Delivery::keysChanged<UnicastScope>();

}  // namespace javinolib
