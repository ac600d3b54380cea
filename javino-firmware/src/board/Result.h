#pragma once

#include <stdint.h>

namespace javinolib {

/// What an action returns to its agent beside success: a number, as a reply of more bytes would not be remembered for repeats.
class Result {
 public:
  Result() : number_(0), state_(NONE) {}

  // Sets the number, -8388608…8388607. Returns false, and the agent gets none, if it is beyond: that is counted.
  bool number(long number) {
    const bool fits = number >= -LIMIT && number < LIMIT;
    number_ = number;
    state_ = fits ? NUMBER : BEYOND;
    return fits;
  }

 private:
  friend class Actions;

  static const long LIMIT = 0x800000;

  enum State : uint8_t { NONE, NUMBER, BEYOND };

  long number_;
  State state_;
};

}  // namespace javinolib
