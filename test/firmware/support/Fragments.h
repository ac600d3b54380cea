#pragma once

#include <delivery/Fragments.h>

#include <string>
#include <vector>

#include "Bytes.h"

/// The fragments of a message of another board.
const Bytes NONCE = {0, 0, 5, 0, 1, 2};

/// The fragments of a whole frame, all without a wish for an answer.
/// @param id 0…63
/// @param longest the most bytes of a fragment
std::vector<Bytes> cut(const Bytes &frame, uint8_t id, uint8_t longest = javinolib::FRAGMENT_LENGTH);

/// A fragment whose sender wants an answer.
Bytes wantingAnswer(Bytes fragment);

/// The packet by which another board would acknowledge a frame with this nonce.
/// @param type 6, 7 or 8, or 0x16 or 0x17 (SPEC 7.3)
/// @param body what comes before the proof
Bytes acknowledgement(const Bytes &key, const std::string &sender, const std::string &acknowledger, const Bytes &nonce,
                      uint8_t type, const Bytes &body = Bytes());
