#include "Vectors.h"

#include <jansson.h>

#include <memory>
#include <stdexcept>

namespace {

typedef std::unique_ptr<json_t, void (*)(json_t *)> Json;

// The list of that name of test/vectors/FILE.
class List {
 public:
  List(const std::string &file, const char *name) : file_(file), root_(load(file)) {
    list_ = json_object_get(root_.get(), name);
    if (!list_) throw std::runtime_error(file + ": no list named " + name);
  }

  size_t size() const { return json_array_size(list_); }

  std::string text(size_t index, const char *key) const {
    const char *value = json_string_value(valueOf(index, key));
    if (!value) throw std::runtime_error(file_ + ": no text named " + key);
    return value;
  }

  Bits bits(size_t index) const {
    Bits result;
    for (char digit : text(index, "bits")) result.push_back(digit == '1');
    return result;
  }

  Bytes bytes(size_t index, const char *key) const {
    const std::string hex = text(index, key);
    Bytes result;
    for (size_t i = 0; i + 1 < hex.size(); i += 2) {
      result.push_back(static_cast<uint8_t>(std::stoul(hex.substr(i, 2), nullptr, 16)));
    }
    return result;
  }

  uint8_t number(size_t index, const char *key) const {
    return static_cast<uint8_t>(json_integer_value(valueOf(index, key)));
  }

  Bytes numbers(size_t index, const char *key) const {
    Bytes result;
    size_t i;
    json_t *number;
    json_array_foreach(valueOf(index, key), i, number) {
      result.push_back(static_cast<uint8_t>(json_integer_value(number)));
    }
    return result;
  }

 private:
  static Json load(const std::string &file) {
    json_error_t error;
    json_t *root = json_load_file((std::string(VECTORS "/") + file).c_str(), 0, &error);
    if (!root) throw std::runtime_error(file + ": " + error.text);
    return Json(root, [](json_t *json) { json_decref(json); });
  }

  json_t *valueOf(size_t index, const char *key) const { return json_object_get(json_array_get(list_, index), key); }

  const std::string file_;
  const Json root_;
  json_t *list_;
};

}  // namespace

std::vector<RadioVector> radioVectors() {
  const List list("radio.json", "packets");
  std::vector<RadioVector> vectors;
  for (size_t i = 0; i < list.size(); i++) vectors.push_back({list.bytes(i, "payload"), list.bits(i)});
  return vectors;
}

std::vector<InvalidRadioVector> invalidRadioVectors() {
  const List list("radio.json", "invalid");
  std::vector<InvalidRadioVector> vectors;
  for (size_t i = 0; i < list.size(); i++) vectors.push_back({list.text(i, "why"), list.bits(i)});
  return vectors;
}

std::vector<CopyVector> copyVectors() {
  const List list("radio.json", "copies");
  std::vector<CopyVector> vectors;
  for (size_t i = 0; i < list.size(); i++) {
    vectors.push_back({list.bytes(i, "payload"), list.number(i, "path"), list.bits(i)});
  }
  return vectors;
}

std::vector<TrailerVector> trailerVectors() {
  const List list("radio.json", "trailers");
  std::vector<TrailerVector> vectors;
  for (size_t i = 0; i < list.size(); i++) {
    vectors.push_back({list.bytes(i, "payload"), list.bytes(i, "trailer"), list.bits(i)});
  }
  return vectors;
}

std::vector<ParityVector> parityVectors() {
  const List list("parity.json", "parities");
  std::vector<ParityVector> vectors;
  for (size_t i = 0; i < list.size(); i++) vectors.push_back({list.bytes(i, "bytes"), list.bytes(i, "parity")});
  return vectors;
}

std::vector<DamagedVector> damagedVectors() {
  const List list("parity.json", "damaged");
  std::vector<DamagedVector> vectors;
  for (size_t i = 0; i < list.size(); i++) {
    vectors.push_back({list.bytes(i, "received"), list.numbers(i, "erasures"), list.bytes(i, "codeword")});
  }
  return vectors;
}
