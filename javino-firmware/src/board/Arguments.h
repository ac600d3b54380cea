#pragma once

#include <stddef.h>
#include <stdint.h>

#include "../Config.h"

namespace javinolib {

/// The action that an agent asks for, `name` or `name(arguments)`, as a view on the request's bytes (SPEC 4.3, act).
/// Arguments are the texts between the commas outside of quotes and brackets, without the blanks around them.
class Arguments {
 public:
  Arguments() : name_(nullptr), nameLength_(0), inner_(nullptr), innerLength_(0), count_(0) {}

  /// Reads an action.
  /// @return false if there is no name, or brackets or quotes do not match, or an argument is empty.
  bool parse(const uint8_t *action, Length length);

  /// The action's name, not ended by a zero.
  const char *name() const { return name_; }
  Length nameLength() const { return nameLength_; }

  uint8_t count() const { return count_; }

  // Reads argument `index` (from 0) as a whole number.
  // Returns false, and leaves `into` as it was, if there is no such argument or it is no whole number that fits a long.
  bool integer(uint8_t index, long &into) const;

  // Copies argument `index` (from 0) as text, ended by a zero: the content of a quoted argument, any other unchanged.
  // Returns false, with `into` undefined, if there is no such argument or it needs more than `size` bytes.
  bool text(uint8_t index, char *into, size_t size) const;

 private:
  struct Span {
    const char *at;
    Length length;
  };

  bool parseName(const char *action, Length length);
  bool find(uint8_t index, Span &into, uint8_t &number) const;
  bool find(uint8_t index, Span &into) const {
    uint8_t number;
    return index < count_ && find(index, into, number);
  }

  static const uint8_t NONE = 0xFF;

  const char *name_;
  Length nameLength_;
  const char *inner_;  // between the outer brackets
  Length innerLength_;
  uint8_t count_;
};

}  // namespace javinolib
