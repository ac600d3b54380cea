#include "Vectors.h"

#include <jansson.h>

#include <memory>
#include <stdexcept>

namespace {

typedef std::unique_ptr<json_t, void (*)(json_t *)> Json;

Json load() {
  json_error_t error;
  json_t *root = json_load_file(VECTORS "/radio.json", 0, &error);
  if (!root) throw std::runtime_error(std::string(VECTORS "/radio.json: ") + error.text);
  return Json(root, [](json_t *json) { json_decref(json); });
}

std::string text(json_t *object, const char *key) {
  const char *value = json_string_value(json_object_get(object, key));
  if (!value) throw std::runtime_error(std::string("radio.json: no text named ") + key);
  return value;
}

Bits bits(json_t *object) {
  Bits result;
  for (char digit : text(object, "bits")) result.push_back(digit == '1');
  return result;
}

Bytes payload(json_t *object) {
  const std::string hex = text(object, "payload");
  Bytes result;
  for (size_t i = 0; i + 1 < hex.size(); i += 2) {
    result.push_back(static_cast<uint8_t>(std::stoul(hex.substr(i, 2), nullptr, 16)));
  }
  return result;
}

}  // namespace

std::vector<RadioVector> radioVectors() {
  const Json root = load();
  std::vector<RadioVector> vectors;
  size_t index;
  json_t *entry;
  json_array_foreach(json_object_get(root.get(), "packets"), index, entry) {
    vectors.push_back({payload(entry), bits(entry)});
  }
  return vectors;
}

std::vector<InvalidRadioVector> invalidRadioVectors() {
  const Json root = load();
  std::vector<InvalidRadioVector> vectors;
  size_t index;
  json_t *entry;
  json_array_foreach(json_object_get(root.get(), "invalid"), index, entry) {
    vectors.push_back({text(entry, "why"), bits(entry)});
  }
  return vectors;
}
