// A codeword with any damage and any erasures: it is mended where the code can, becomes another codeword as near, or stays as
// it is. And any calls on a decoder come to an end.

#include <radio/ReedSolomon.h>

#include <algorithm>

#include "Input.h"

using namespace javinolib::reedsolomon;

namespace {

typedef std::vector<uint8_t> Bytes;

const int MOST_STEPS = 40;

bool isCodeword(const Bytes &bytes) {
  Bytes parity(PARITY_LENGTH);
  const size_t length = bytes.size() - PARITY_LENGTH;
  encode(bytes.data(), static_cast<uint8_t>(length), parity.data());
  return std::equal(parity.begin(), parity.end(), bytes.begin() + static_cast<long>(length));
}

Progress finish(Decoder &decoder) {
  Progress progress = Progress::PENDING;
  for (int i = 0; i < MOST_STEPS && progress == Progress::PENDING; i++) progress = decoder.step();
  require(progress != Progress::PENDING, "each codeword comes to an end");
  return progress;
}

size_t wrongBytes(const Bytes &a, const Bytes &b, const std::vector<bool> &erased) {
  size_t count = 0;
  for (size_t i = 0; i < a.size(); i++) count += a[i] != b[i] && !erased[i];
  return count;
}

void damageAndMend(Input &input) {
  Bytes sent = input.bytes(238);
  sent.push_back(input.byte());
  const uint8_t length = static_cast<uint8_t>(sent.size());
  sent.resize(length + PARITY_LENGTH);
  encode(sent.data(), length, sent.data() + length);
  Bytes received = sent;
  std::vector<bool> erased(sent.size());
  for (int left = input.byte() % 20; left > 0; left--) received[input.byte() % sent.size()] ^= input.byte();
  for (int left = input.byte() % 18; left > 0; left--) erased[input.byte() % sent.size()] = true;

  Bytes codeword = received;
  Decoder decoder;
  decoder.begin(codeword.data(), static_cast<uint8_t>(codeword.size()));
  for (size_t i = 0; i < erased.size(); i++) {
    if (erased[i]) decoder.erase(static_cast<uint8_t>(i));
  }
  const Progress progress = finish(decoder);
  const size_t erasures = static_cast<size_t>(std::count(erased.begin(), erased.end(), true));
  if (2 * wrongBytes(sent, received, erased) + erasures <= PARITY_LENGTH)
    require(progress == Progress::CORRECTED && codeword == sent, "what the parity allows is mended");
  if (progress == Progress::FAILED) {
    require(codeword == received, "what cannot be mended stays");
  } else {
    require(isCodeword(codeword), "what was mended is a codeword");
    require(2 * wrongBytes(codeword, received, erased) + erasures <= PARITY_LENGTH, "and one that is near enough");
  }
}

void callAnything(Input &input) {
  Bytes codeword = input.bytes(255);
  Decoder decoder;
  decoder.begin(codeword.data(), static_cast<uint8_t>(codeword.size()));
  while (!input.empty()) {
    const uint8_t what = input.byte();
    if (what % 4 == 0) {
      decoder.step();
    } else {
      decoder.erase(what);
    }
  }
  finish(decoder);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  if (size > 600) return 0;
  Input input(data, size);
  if (input.byte() % 8 == 0) {
    callAnything(input);
  } else {
    damageAndMend(input);
  }
  return 0;
}
