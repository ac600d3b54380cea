#pragma once

#include <stdint.h>

#include "../support/NoInline.h"
#include "Reply.h"

namespace javino {

/// A record of a poll reply while it is written: `type(1) length(2) value` (SPEC 4.3). It gets into the reply whole or
/// not at all.
class Record {
 public:
  Record(Reply &reply, char type);

  JAVINO_NOINLINE void add(uint8_t byte);
  JAVINO_NOINLINE void add(const uint8_t *bytes, uint16_t length);

  /// Ends the record.
  /// @return false, and the reply is as it was before, where it did not fit.
  bool close();

 private:
  static const uint8_t HEAD_LENGTH = 3;

  Reply &reply_;
  const uint16_t start_;
  bool fits_;
};

}  // namespace javino
