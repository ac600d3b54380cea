#include <framing/Frame.h>
#include <gtest/gtest.h>
#include <secure/Proof.h>

#include "support/Addresses.h"
#include "support/Vectors.h"

using javinolib::Address;
using javinolib::Proof;

namespace {

const size_t HEADER = javinolib::HEADER_LENGTH;

// The type that an acknowledgement's length stands for; throws where it stands for none.
Proof::Type typeOf(const Bytes &frame) {
  for (Proof::Type type : {Proof::DELIVERED, Proof::FRAGMENTS, Proof::STALE}) {
    if (frame.size() == HEADER + Proof::bodyLength(type) + Proof::LENGTH) return type;
  }
  throw std::invalid_argument("no acknowledgement has this length: " + toHex(frame));
}

// An acknowledgement and what it answers.
struct Case {
  explicit Case(const Vector &vector)
      : frame(vector.bytes("frame")),
        nonce(vector.bytes("nonce")),
        sender(addressOf(vector.text("sender"))),
        acknowledger(addressOf(vector.text("acknowledger"))) {
    keys.derive(vector.bytes("key").data());
  }

  Proof::Claim claim() const {
    return {typeOf(frame), nonce.data(), sender, acknowledger, frame.data() + HEADER, false};
  }
  const uint8_t *proof() const { return frame.data() + frame.size() - Proof::LENGTH; }
  bool isRight() const {
    uint8_t expected[Proof::LENGTH];
    Proof(keys).make(claim(), expected);
    return memcmp(expected, proof(), sizeof expected) == 0;
  }

  Bytes frame;
  Bytes nonce;
  Address sender;
  Address acknowledger;
  javinolib::DerivedKeys keys;
};

bool hasProof(const Bytes &frame) {
  const size_t length = frame.size() - HEADER;
  return length == 8 || length == 9 || length == 16;
}

}  // namespace

TEST(Proof, makes_those_of_all_valid_vectors) {
  for (const Vector &vector : vectors("acknowledgements.json", "valid")) {
    SCOPED_TRACE(vector.toString());
    const Case given(vector);
    Bytes proof(Proof::LENGTH);
    Proof(given.keys).make(given.claim(), proof.data());
    EXPECT_EQ(Bytes(given.proof(), given.proof() + Proof::LENGTH), proof);
    EXPECT_TRUE(given.isRight());
  }
}

TEST(Proof, refuses_those_of_all_invalid_vectors_whose_shape_and_address_are_right) {
  int refused = 0;
  for (const Vector &vector : vectors("acknowledgements.json", "invalid")) {
    SCOPED_TRACE(vector.toString());
    const Case given(vector);
    if (!hasProof(given.frame) || vector.text("why") == "the address is of another nonce") continue;
    EXPECT_FALSE(given.isRight());
    refused++;
  }
  EXPECT_GE(refused, 15);
}

TEST(Proof, is_wrong_for_any_changed_bit_of_what_it_covers_and_of_itself) {
  for (const Vector &vector : vectors("acknowledgements.json", "valid")) {
    SCOPED_TRACE(vector.toString());
    for (size_t bit = HEADER * 8; bit < Case(vector).frame.size() * 8; bit++) {
      Case changed(vector);
      changed.frame[bit / 8] = static_cast<uint8_t>(changed.frame[bit / 8] ^ 1 << bit % 8);
      EXPECT_FALSE(changed.isRight()) << bit;
    }
    for (size_t bit = 0; bit < 6 * 8; bit++) {
      Case changed(vector);
      changed.nonce[bit / 8] = static_cast<uint8_t>(changed.nonce[bit / 8] ^ 1 << bit % 8);
      EXPECT_FALSE(changed.isRight()) << bit;
    }
  }
}

TEST(Proof, is_wrong_with_sender_and_acknowledger_exchanged) {
  for (const Vector &vector : vectors("acknowledgements.json", "valid")) {
    Case given(vector);
    std::swap(given.sender, given.acknowledger);
    EXPECT_FALSE(given.isRight()) << vector.toString();
  }
}
