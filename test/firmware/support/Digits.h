#pragma once
#include <string>

/// Base64's alphabet (SPEC 1), for all tests in C++.
static const std::string DIGITS = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
