#pragma once

#include "../firmware/support/Bytes.h"
#include "Mega.h"

/// The Mega that all tests of a run share, and how they ask it.
Mega &mega();

/// The result of an operation.
struct Outcome {
  uint64_t cycles;
  Mailbox mailbox;

  /// The first bytes of the mailbox's data.
  Bytes bytes(size_t count) const { return Bytes(mailbox.bytes, mailbox.bytes + count); }
};

/// Throws where `data` does not fit the mailbox.
/// @param key, second 16 bytes, or none where the operation takes none
/// @param nonce 6 bytes or none
Outcome perform(Mailbox::Operation operation, const Bytes &key, const Bytes &second, const Bytes &data,
                const Bytes &nonce = Bytes());

/// A board's last reply to bytes of the line, and the cycles from the last bytes, as many as `measured` says (0 for all), to
/// that reply's first one.
Outcome answer(const Bytes &line, uint8_t measured);
