// The text of an action: Arguments finds the arguments that ArgumentScanner divides, and reads each without overrun.

#include <board/Arguments.h>

#include <cstring>
#include <string>
#include <vector>

#include "Input.h"

using javinolib::Arguments;

namespace {

void checkText(const Arguments &arguments, uint8_t index, size_t room) {
  std::vector<char> into(room);
  if (arguments.text(index, into.data(), into.size())) {
    require(std::memchr(into.data(), 0, room) != nullptr, "a text is ended by a zero");
  }
}

void checkArgument(const Arguments &arguments, uint8_t index, size_t enough) {
  long number = 0;
  std::string digits(enough, 0);
  const bool isNumber = arguments.integer(index, number);
  require(arguments.text(index, &digits[0], enough), "each argument is a text");
  require(!isNumber || std::stol(digits) == number, "a number is what its text says");
  for (size_t room : {0, 1, 2, 7}) checkText(arguments, index, room);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  if (size > 511) return 0;
  Arguments arguments;
  if (!arguments.parse(data, static_cast<uint16_t>(size))) return 0;
  require(arguments.nameLength() >= 1 && arguments.nameLength() <= size, "a name is within the action");
  require(std::memcmp(arguments.name(), data, arguments.nameLength()) == 0, "it is the action's beginning");
  for (unsigned i = 0; i < arguments.count(); i++) checkArgument(arguments, static_cast<uint8_t>(i), size + 1);
  checkText(arguments, arguments.count(), size + 1);
  long untouched = 5;
  require(!arguments.integer(arguments.count(), untouched) && untouched == 5, "there are no more than count() says");
  return 0;
}
