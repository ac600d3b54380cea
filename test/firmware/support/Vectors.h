#pragma once

#include <jansson.h>

#include <string>
#include <vector>

#include "Bytes.h"

/// One entry of a list in test/vectors.
class Vector {
 public:
  explicit Vector(json_t *object) : object_(object) {}

  /// These throw where the field is missing or of another type.
  std::string text(const char *field) const;
  Bytes bytes(const char *field) const { return fromHex(text(field)); }
  long number(const char *field) const;
  std::vector<Bytes> bytesList(const char *field) const;
  std::vector<Vector> vectors(const char *field) const;

  /// The whole entry, for messages.
  std::string toString() const;

 private:
  json_t *get(const char *field) const;

  json_t *object_;
};

/// Reads a list of a file of test/vectors, e.g. `frames.json`, `valid`. Throws where there is none or it is empty:
/// a test that reads no vector shows nothing.
std::vector<Vector> vectors(const std::string &file, const char *list);
