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
  Span all;
  return parseName(reinterpret_cast<const char *>(action), length) && (inner_ == nullptr || find(NONE, all, count_));
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

// Goes from argument to argument, without the blanks around each, up to one of them; false if one is empty. Or up to the end:
// then `number` is how many there are, and false if brackets or quotes do not match. No message has room for 255.
bool Arguments::find(uint8_t index, Span &into, uint8_t &number) const {
  ArgumentScanner scanner;
  const char *const end = inner_ + innerLength_;
  into.length = 0;
  number = 0;
  for (const char *at = inner_;; at++) {
    const bool ends = at == end;
    if (ends || scanner.add(*at)) {
      if (into.length == 0) return false;
      if (number++ == index) return true;
      if (ends) return scanner.balanced();
      into.length = 0;
    } else if (!isBlank(*at)) {
      if (into.length == 0) into.at = at;
      into.length = static_cast<Length>(at - into.at + 1);
    }
  }
}

}  // namespace javinolib
