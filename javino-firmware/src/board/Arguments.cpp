#include "Arguments.h"

#include <limits.h>

#include "ArgumentScanner.h"

namespace javinolib {

namespace {

bool isBlank(char next) { return next == ' ' || next == '\t'; }
bool isDigit(char next) { return next >= '0' && next <= '9'; }

bool isNameCharacter(char next) {
  return (next >= 'a' && next <= 'z') || (next >= 'A' && next <= 'Z') || isDigit(next) || next == '_' || next == '.';
}

}  // namespace

bool Arguments::parse(const uint8_t *action, Length length) {
  *this = Arguments();
  return parseName(reinterpret_cast<const char *>(action), length) && (inner_ == nullptr || countArguments());
}

bool Arguments::integer(uint8_t index, long &into) const {
  Span span;
  if (!find(index, span)) return false;
  const bool negative = span.at[0] == '-';
  const unsigned long most = static_cast<unsigned long>(LONG_MAX) + negative;
  unsigned long magnitude = 0;
  if (span.length == negative) return false;
  for (uint16_t i = negative; i < span.length; i++) {
    if (!isDigit(span.at[i])) return false;
    if (magnitude > LONG_MAX / 10) return false;
    magnitude = magnitude * 10 + static_cast<uint8_t>(span.at[i] - '0');
    if (magnitude > most) return false;
  }
  // The smallest long has no positive counterpart, so one less is negated.
  into = negative && magnitude != 0 ? -static_cast<long>(magnitude - 1) - 1 : static_cast<long>(magnitude);
  return true;
}

bool Arguments::text(uint8_t index, char *into, size_t size) const {
  Span span;
  if (!find(index, span)) return false;
  const bool quoted = span.length >= 2 && span.at[0] == '"' && span.at[span.length - 1] == '"';
  const Length end = static_cast<Length>(span.length - quoted);
  size_t used = 0;
  for (uint16_t i = quoted; i < end; i++) {
    char next = span.at[i];
    if (quoted && next == '\\' && i + 1 < end) {
      next = span.at[++i];
      if (next == 'n') next = '\n';
    }
    if (used + 1 >= size) return false;
    into[used++] = next;
  }
  if (used >= size) return false;
  into[used] = 0;
  return true;
}

bool Arguments::parseName(const char *action, Length length) {
  name_ = action;
  while (nameLength_ < length && isNameCharacter(action[nameLength_])) nameLength_++;
  if (nameLength_ == 0) return false;
  if (nameLength_ == length) return true;
  if (action[nameLength_] != '(' || action[length - 1] != ')') return false;
  inner_ = action + nameLength_ + 1;
  innerLength_ = static_cast<Length>(length - nameLength_ - 2);
  return nameLength_ + 2 <= length;
}

bool Arguments::countArguments() {
  ArgumentScanner scanner;
  bool isEmpty = true;
  for (uint16_t i = 0; i < innerLength_; i++) {
    if (!scanner.add(inner_[i])) {
      isEmpty = isEmpty && isBlank(inner_[i]);
    } else if (isEmpty || ++count_ == UINT8_MAX) {
      return false;
    } else {
      isEmpty = true;
    }
  }
  count_++;
  return !isEmpty && scanner.balanced();
}

// Finds an argument; false where there is none of this index or it is empty.
bool Arguments::find(uint8_t index, Span &into) const {
  if (index >= count_) return false;
  ArgumentScanner scanner;
  Length start = 0;
  Length end = 0;
  for (; end < innerLength_; end++) {
    if (!scanner.add(inner_[end])) continue;
    if (index-- == 0) break;
    start = static_cast<uint16_t>(end + 1);
  }
  while (start < end && isBlank(inner_[start])) start++;
  while (start < end && isBlank(inner_[end - 1])) end--;
  into.at = inner_ + start;
  into.length = static_cast<Length>(end - start);
  return into.length != 0;
}

}  // namespace javinolib
