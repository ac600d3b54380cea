#pragma once
#include <string>

/// Base64's alphabet (SPEC 1), for all tests in C++; a function, as other constants are made by it.
inline const std::string &digits() {
  static const std::string DIGITS = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  return DIGITS;
}
