// Holds what the firmware costs, by the compilers of Debian 12 and 13, to the figures in budget.json, and writes both to cycles.txt.
#include <gtest/gtest.h>
#include <jansson.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <stdexcept>

#include "../firmware/support/Reference.h"
#include "../firmware/support/Vectors.h"
#include "TestMega.h"

namespace {

typedef std::map<std::string, double> Figures;

const Bytes KEY = fromHex("2b7e151628aed2a6abf7158809cf4f3c");
const Bytes SECOND = fromHex("000102030405060708090a0b0c0d0e0f");

Bytes random(size_t count) { return RandomBytes(7).bytes(count); }

double cyclesOf(Mailbox::Operation operation, const Bytes &data) {
  return static_cast<double>(perform(operation, KEY, SECOND, data, fromHex("000001000000")).cycles);
}

double cyclesAByte(Mailbox::Operation operation, const Bytes &data) {
  return cyclesOf(operation, data) / static_cast<double>(data.size());
}

#ifdef JAVINO_SMALL
const size_t PERCEPTS = 20;
const size_t MAX_MESSAGE = 96;
#else
const size_t PERCEPTS = 40;
const size_t MAX_MESSAGE = 511;
#endif

// The longest packet that a board takes, with its closing zero: header and CRC weigh least.
Bytes longestPacket() { return reference::packet(1, reference::frame("++++", "++++", random(MAX_MESSAGE))); }

// The content of 16 bytes, from ROMA to SUHO: 'C' and 'A' are the digits of 128 bits.
Bytes frame() { return bytesOf("SUHOROMACA") + random(16); }

Bytes sealedFrame() {
  const Outcome sealed = perform(Mailbox::SEAL, KEY, SECOND, frame(), fromHex("000001000000"));
  return sealed.bytes(sealed.mailbox.length);
}

const size_t LONGEST_PAYLOAD = 77;

// The cycles of the interrupts, for each bit of the longest packet.
double cyclesABitHeard() {
  const Outcome heard = perform(Mailbox::HEAR_PACKET, {}, {}, random(LONGEST_PAYLOAD));
  if (heard.bytes(heard.mailbox.length) != random(LONGEST_PAYLOAD))
    throw std::runtime_error("the packet was not received");
  return static_cast<double>(heard.cycles) / (84 + 12 * LONGEST_PAYLOAD);
}

#ifndef JAVINO_SMALL

struct Mending {
  double longestStep = 0, erasing = 0, all = 0;
  bool mended = false;

  void add(double step) {
    longestStep = std::max(longestStep, step);
    all += step;
  }

  void keepLonger(const Mending &other) {
    longestStep = std::max(longestStep, other.longestStep);
    erasing = std::max(erasing, other.erasing);
    all = std::max(all, other.all);
  }
};

// The mending of the longest packet, each so many-th symbol of which is wrong, when so many copies of it have come.
Mending mendPacket(uint8_t distance, uint8_t copies) {
  const Bytes payload = RandomBytes(10u * distance + copies).bytes(LONGEST_PAYLOAD);
  Mending mending;
  for (uint8_t steps = 0;; steps++) {
    const Outcome step = perform(Mailbox::MEND_PACKET, {}, {}, payload, {steps, distance, copies, 0, 0, 0});
    mending.add(static_cast<double>(step.cycles));
    mending.mended = step.mailbox.length == 1;
    if (step.mailbox.length != 0) return mending;
  }
}

// The most that any damage takes: a copy alone that has too much is given up; two together are mended.
Mending longestMendingOfPacket() {
  Mending longest;
  for (uint8_t distance : {2, 3, 10, 40, 160}) {
    for (uint8_t copies : {0, 1}) {
      const Mending mending = mendPacket(distance, copies);
      if (mending.mended != (distance >= 40 || (copies == 1 && distance > 2)))
        throw std::runtime_error("the packet was not mended, or was by chance");
      longest.keepLonger(mending);
    }
  }
  return longest;
}

const size_t PARITY_LENGTH = 16;

Bytes parity() { return perform(Mailbox::ADD_PARITY, {}, {}, random(80)).bytes(PARITY_LENGTH); }

// The bytes of the longest codeword that are erased, and the further ones that are wrong.
struct Damage {
  uint8_t erasures, errors;
};

Mending mend(const Damage &damage) {
  const Bytes codeword = random(80) + parity();
  Outcome state = {};
  state.mailbox.length = static_cast<uint16_t>(codeword.size());
  state.mailbox.measured = damage.erasures;
  std::copy(codeword.begin(), codeword.end(), state.mailbox.bytes);
  for (uint8_t i = 0; i < damage.erasures + damage.errors; i++) {
    const uint8_t position = static_cast<uint8_t>(5 * i);
    if (i < damage.erasures) state.mailbox.second[i] = position;
    state.mailbox.bytes[position] ^= static_cast<uint8_t>(i + 1);
  }
  Mending mending;
  Mailbox mailbox = state.mailbox;
  mending.erasing = static_cast<double>(mega().perform(Mailbox::ERASE, mailbox));
  for (uint8_t steps = 0;; steps++) {
    mailbox = state.mailbox;
    mailbox.nonce[0] = steps;
    const double cycles = static_cast<double>(mega().perform(Mailbox::MEND_STEP, mailbox));
    mending.add(cycles);
    if (mailbox.length != 0) break;
  }
  mending.mended = std::equal(codeword.begin(), codeword.end(), mailbox.bytes);
  return mending;
}

// The most that any damage takes, which may be too much to be mended.
Mending longestMending() {
  Mending longest;
  for (const Damage &damage :
       {Damage{0, 8}, Damage{8, 4}, Damage{15, 0}, Damage{16, 0}, Damage{0, 12}, Damage{14, 5}}) {
    const Mending mending = mend(damage);
    if (mending.mended != (2 * damage.errors + damage.erasures <= 16))
      throw std::runtime_error("the codeword was not mended, or was by chance");
    longest.keepLonger(mending);
  }
  return longest;
}

#endif

// COBS, CRC, and little more: nothing is done before a hello.
double cyclesAByteHeard() {
  const Bytes packet = longestPacket();
  return static_cast<double>(answer(packet, 0).cycles) / static_cast<double>(packet.size());
}

double cyclesOfReading() {
  const Bytes hello = reference::packet(1, reference::frame("++++", "++++", {'H', 1}));
  const Bytes poll = reference::packet(2, reference::frame("++++", "++++", {'P', 3, 0, 0, 0, 0, 0}));
  const Outcome told = answer(hello + poll, 1);
  const Bytes reply = reference::cobsDecoded(told.bytes(static_cast<size_t>(told.mailbox.length - 1)));
  const size_t overhead = 1 + 10 + 2 + 2;  // sequence, header, status and flags, CRC
  if (reply.size() != overhead + PERCEPTS * (3 + 9)) throw std::runtime_error("not the reading: " + toHex(reply));
  return static_cast<double>(told.cycles);
}

Figures measured() {
  Figures figures;
  figures["AES-128, one block, call included"] = cyclesOf(Mailbox::ENCRYPT_BLOCK, random(16));
  figures["AES-128 key schedule, call included"] = cyclesOf(Mailbox::EXPAND_KEY, {});
  figures["CFB-128, encrypt 64 bytes"] = cyclesOf(Mailbox::ENCRYPT_CFB, random(64));
  figures["CFB-128, decrypt 64 bytes"] = cyclesOf(Mailbox::DECRYPT_CFB, random(64));
  figures["CMAC, 32 bytes"] = cyclesOf(Mailbox::COMPUTE_CMAC, random(32));
  figures["keys of a shared key: Kenc, Kmac, check value"] = cyclesOf(Mailbox::DERIVE_KEYS, {});
  const double expansion = cyclesOf(Mailbox::EXPAND_KEYS, {});
  figures["envelope: expand and wipe both keys"] = expansion;
  figures["seal 16 bytes, keys expanded"] = cyclesOf(Mailbox::SEAL, frame()) - expansion;
  figures["open 16 bytes, keys expanded"] = cyclesOf(Mailbox::OPEN, sealedFrame()) - expansion;
  figures["CRC-16, a byte"] = cyclesAByte(Mailbox::ADD_TO_CRC, random(500));
  figures["serial packet received, a byte"] = cyclesAByteHeard();
  figures["radio interrupts, a bit received"] = cyclesABitHeard();
  figures["reading of " + std::to_string(PERCEPTS) + " percepts, to its first byte"] = cyclesOfReading();
#ifndef JAVINO_SMALL
  const Mending packet = longestMendingOfPacket();
  figures["radio, the longest step of mending a packet"] = packet.longestStep;
  figures["radio, all steps of mending a packet"] = packet.all;
  figures["parity of 80 bytes"] = cyclesOf(Mailbox::ADD_PARITY, random(80));
  const Mending mending = longestMending();
  figures["parity, 16 bytes erased"] = mending.erasing;
  figures["parity, the longest step of mending 96 bytes"] = mending.longestStep;
  figures["parity, all steps of mending 96 bytes"] = mending.all;
#endif
  return figures;
}

Figures budget() {
  json_error_t error;
  json_t *root = json_load_file(BUDGET, 0, &error);
  if (root == nullptr) throw std::runtime_error(std::string(BUDGET) + ": " + error.text);
  Figures figures;
  const char *what;
  json_t *cycles;
  json_object_foreach(root, what, cycles) figures[what] = json_number_value(cycles);
  json_decref(root);
  return figures;
}

}  // namespace

TEST(Budget, is_kept) {
  const Figures now = measured();
  Figures allowed = budget();
  FILE *table = fopen(TABLE, "w");
  ASSERT_NE(nullptr, table) << TABLE;
  fprintf(table, "%-48s %10s %10s\n", "what", "cycles", "budget");
  for (const auto &figure : now) {
    const auto limit = allowed.find(figure.first);
    if (limit == allowed.end()) {
      ADD_FAILURE() << "budget.json has no budget for \"" << figure.first << "\"";
      continue;
    }
    fprintf(table, "%-48s %10.1f %10.1f\n", figure.first.c_str(), figure.second, limit->second);
    EXPECT_LE(figure.second, limit->second) << figure.first;
    allowed.erase(limit);
  }
  fclose(table);
  for (const auto &limit : allowed)
    ADD_FAILURE() << "budget.json names \"" << limit.first << "\", which nobody measures";
}
