#include "Delivery.h"

namespace javino {

bool Delivery::begin() {
  seed();
  courier_.begin();
  return medium_.begin();
}

// What came first, since an acknowledgement may end what would else be sent again; then our own acknowledgements.
void Delivery::run() {
  medium_.update();
  receiver_.run();
  acknowledger_.run();
  courier_.run();
}

void Delivery::keysChanged() {
  inbox_.keysChanged(state_.keys);
  acknowledger_.keysChanged();
  courier_.keysChanged();
}

}  // namespace javino
