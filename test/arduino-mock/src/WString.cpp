#include "WString.h"

#include <iomanip>
#include <sstream>

static const char *inMemory(const __FlashStringHelper *text) { return reinterpret_cast<const char *>(text); }

String::String(double number, unsigned char decimals) {
  std::ostringstream out;
  out << std::fixed << std::setprecision(decimals) << number;
  text_ = out.str();
}

String &String::operator=(const __FlashStringHelper *text) {
  text_ = inMemory(text);
  return *this;
}

String &String::operator+=(const String &other) {
  text_ += other.text_;
  return *this;
}

String &String::operator+=(char character) {
  text_ += character;
  return *this;
}

bool String::operator==(const __FlashStringHelper *text) const { return text_ == inMemory(text); }
