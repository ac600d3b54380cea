#pragma once

#include <stdint.h>

namespace javinolib {

/// Follows quotes and brackets through the text of a term, one character at a time, to tell which commas divide
/// arguments.
class ArgumentScanner {
 public:
  ArgumentScanner() : open_(0), depth_(0), quoted_(false), escaped_(false), broken_(false) {}

  /// @return whether this character is a comma that divides two arguments.
  bool add(char next);

  /// Whether all that was opened has been closed, and nothing else.
  bool balanced() const { return !broken_ && !quoted_ && depth_ == 0; }

 private:
  static const uint8_t MAX_DEPTH = 16;

  void open(bool isSquare);
  void close(bool isSquare);

  uint16_t open_;  // the brackets that are to be closed, a bit each, the innermost lowest
  uint8_t depth_;
  bool quoted_;
  bool escaped_;
  bool broken_;
};

}  // namespace javinolib
