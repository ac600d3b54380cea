#include "Delivery.h"

namespace javino {

void Delivery::begin() {
  seed();
  medium_.begin();
  courier_.begin();
}

// What came first, since an acknowledgement may end what would else be sent again; then our own acknowledgements.
void Delivery::run() {
  medium_.update();
  receiver_.run();
  acknowledger_.run();
  courier_.run();
}

void Delivery::keysChanged() {
  inbox_.keysChanged(keys_);
  acknowledger_.keysChanged();
  courier_.keysChanged();
}

}  // namespace javino
