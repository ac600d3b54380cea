#include "Fragments.h"

#include <delivery/Fragments.h>
#include <secure/Proof.h>

#include "Reference.h"

using namespace javinolib;

std::vector<Bytes> cut(const Bytes &frame, uint8_t id, uint8_t longest) {
  std::vector<Bytes> all;
  const uint16_t length = static_cast<uint16_t>(frame.size());
  for (uint8_t index = 0; index < fragments::count(length, longest); index++) {
    Bytes fragment(HEADER_LENGTH + longest);
    fragment.resize(fragments::cut(frame.data(), length, id, index, longest, fragment.data()));
    all.push_back(fragment);
  }
  return all;
}

Bytes wantingAnswer(Bytes fragment) {
  fragment.at(3) = static_cast<uint8_t>(fragment.at(3) + fragments::WANTS_ANSWER);  // A…H become I…P
  return fragment;
}

Bytes acknowledgement(const Bytes &key, const std::string &sender, const std::string &acknowledger, const Bytes &nonce,
                      uint8_t type, const Bytes &body) {
  DerivedKeys keys;
  keys.derive(key.data());
  const bool asksParity = (type & Proof::ASKS_PARITY) != 0;
  Address to, from;
  Address::parse(bytesOf(sender).data(), to);
  Address::parse(bytesOf(acknowledger).data(), from);
  const auto claimed = static_cast<Proof::Type>(type & ~Proof::ASKS_PARITY);
  const Proof::Claim claim = {claimed, nonce.data(), to, from, body.data(), asksParity};
  Bytes proof(PROOF_LENGTH);
  Proof(keys).make(claim, proof.data());
  Bytes address(4);
  Address::acknowledgement(static_cast<uint16_t>((nonce[4] << 8 | nonce[5]) & 0xFFF)).write(address.data());
  return reference::frame(textOf(address), acknowledger, body + proof);
}
