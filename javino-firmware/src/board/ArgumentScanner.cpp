#include "ArgumentScanner.h"

namespace javinolib {

const uint8_t ArgumentScanner::MAX_DEPTH;

bool ArgumentScanner::add(char next) {
  if (quoted_) {
    if (next == '"' && !escaped_) quoted_ = false;
    escaped_ = next == '\\' && !escaped_;
    return false;
  }
  switch (next) {
    case '"': quoted_ = true; return false;
    case '(': open(')'); return false;
    case '[': open(']'); return false;
    case ')':
    case ']': close(next); return false;
    default: return next == ',' && depth_ == 0;
  }
}

void ArgumentScanner::open(char bracket) {
  if (depth_ == MAX_DEPTH) {
    broken_ = true;
  } else {
    open_[depth_++] = bracket;
  }
}

void ArgumentScanner::close(char bracket) {
  if (depth_ == 0 || open_[depth_ - 1] != bracket) {
    broken_ = true;
  } else {
    depth_--;
  }
}

}  // namespace javinolib
