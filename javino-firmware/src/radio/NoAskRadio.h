#pragma once

#include "Radio.h"

namespace javinolib {

/// Says on another chip why a sketch that names the modem of an ATmega does not compile.
class AskRadio {
 public:
  template <typename... Pins>
  explicit AskRadio(Pins...) {
    static_assert(sizeof...(Pins) + 1 == 0,
                  "JavinoAskRadio: this chip has no timer and pins for it; take another radio");
  }
  operator Radio &();
};

}  // namespace javinolib
