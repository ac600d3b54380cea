#pragma once

#include <string>

class __FlashStringHelper;

/// The part of Arduino's String that is used here.
class String {
 public:
  String(const char *text = "") : text_(text) {}
  explicit String(double number, unsigned char decimals = 2);
  String &operator=(const __FlashStringHelper *text);

  String &operator+=(const String &other);
  String &operator+=(char character);
  bool operator==(const String &other) const { return text_ == other.text_; }
  bool operator==(const __FlashStringHelper *text) const;

  const char *c_str() const { return text_.c_str(); }
  unsigned int length() const { return static_cast<unsigned int>(text_.size()); }
  char operator[](unsigned int at) const { return text_[at]; }
  int indexOf(char character, unsigned int from = 0) const { return static_cast<int>(text_.find(character, from)); }
  String substring(unsigned int from, unsigned int to) const { return text_.substr(from, to - from).c_str(); }

 private:
  std::string text_;
};

inline String operator+(String one, const String &other) { return one += other; }
inline String operator+(String one, char character) { return one += character; }
