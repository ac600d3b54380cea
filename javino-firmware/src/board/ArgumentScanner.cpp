#include "ArgumentScanner.h"

namespace javinolib {

const uint8_t ArgumentScanner::MAX_DEPTH;

bool ArgumentScanner::add(char next) {
  if (quoted_) {
    if (next == '"' && !escaped_) quoted_ = false;
    escaped_ = next == '\\' && !escaped_;
    return false;
  }
  const bool isSquare = next == '[' || next == ']';
  if (next == '"') quoted_ = true;
  if (next == '(' || next == '[') open(isSquare);
  if (next == ')' || next == ']') close(isSquare);
  return next == ',' && depth_ == 0;
}

void ArgumentScanner::open(bool isSquare) {
  if (depth_ == MAX_DEPTH) {
    broken_ = true;
    return;
  }
  depth_++;
  open_ = static_cast<uint16_t>(open_ << 1 | isSquare);
}

void ArgumentScanner::close(bool isSquare) {
  if (depth_ == 0 || (open_ & 1) != isSquare) {
    broken_ = true;
    return;
  }
  depth_--;
  open_ = static_cast<uint16_t>(open_ >> 1);
}

}  // namespace javinolib
