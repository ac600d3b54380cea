#include "Vectors.h"

#include <cstdlib>
#include <map>
#include <stdexcept>

json_t *Vector::get(const char *field) const {
  json_t *value = json_object_get(object_, field);
  if (value == nullptr) throw std::runtime_error(std::string("no field ") + field + " in " + toString());
  return value;
}

std::string Vector::text(const char *field) const {
  json_t *value = get(field);
  if (!json_is_string(value)) throw std::runtime_error(std::string(field) + " is no text in " + toString());
  return std::string(json_string_value(value), json_string_length(value));
}

long Vector::number(const char *field) const {
  json_t *value = get(field);
  if (!json_is_integer(value)) throw std::runtime_error(std::string(field) + " is no number in " + toString());
  return static_cast<long>(json_integer_value(value));
}

std::vector<Bytes> Vector::bytesList(const char *field) const {
  json_t *value = get(field);
  if (!json_is_array(value)) throw std::runtime_error(std::string(field) + " is no list in " + toString());
  std::vector<Bytes> all;
  size_t index;
  json_t *element;
  json_array_foreach(value, index, element) all.push_back(fromHex(json_string_value(element)));
  return all;
}

std::vector<Vector> Vector::vectors(const char *field) const {
  json_t *array = get(field);
  if (!json_is_array(array) || json_array_size(array) == 0)
    throw std::runtime_error(std::string("no vectors in ") + field);
  std::vector<Vector> all;
  size_t index;
  json_t *object;
  json_array_foreach(array, index, object) all.push_back(Vector(object));
  return all;
}

std::string Vector::toString() const {
  char *dump = json_dumps(object_, JSON_COMPACT);
  const std::string text = dump;
  free(dump);
  return text;
}

namespace {

struct Document {
  json_t *root = nullptr;
  ~Document() { json_decref(root); }
};

json_t *load(const std::string &file) {
  static std::map<std::string, Document> documents;
  Document &document = documents[file];
  if (document.root == nullptr) {
    json_error_t error;
    const std::string path = std::string(VECTORS) + "/" + file;
    document.root = json_load_file(path.c_str(), JSON_ALLOW_NUL, &error);
    if (document.root == nullptr) throw std::runtime_error(path + ": " + error.text);
  }
  return document.root;
}

}  // namespace

std::vector<Vector> vectors(const std::string &file, const char *list) { return Vector(load(file)).vectors(list); }
