#pragma once

#include <functional>
#include <string>

#include "Bytes.h"

/// Runs the cases of CMAC that Wycheproof has for keys of 16 bytes, and leaves a row of docs/verdict.md.
/// @param part what of ours is judged
/// @param cmac gives the tag of 16 bytes
/// @return the ids of those that ended otherwise than their authors say
std::string wronglyJudgedCmacs(const std::string &part,
                               const std::function<Bytes(const Bytes &key, const Bytes &message)> &cmac);
