#pragma once

#include <stdint.h>

/// The test's order to the program on the emulated Mega, and its answer: laid out alike by both compilers.
struct Mailbox {
  enum Operation : uint8_t {
    NOTHING,        ///< the cost of measuring
    EXPAND_KEY,     ///< key
    ENCRYPT_BLOCK,  ///< key; the first 16 of bytes, in place
    DERIVE_KEYS,    ///< key; into bytes: Kenc, Kmac, check value
    ENCRYPT_CFB,    ///< key, second as IV; length bytes, in place
    DECRYPT_CFB,    ///< the same
    COMPUTE_CMAC,   ///< key; length bytes; the tag replaces the first 16
    EXPAND_KEYS,    ///< key as Kenc, second as Kmac: makes and wipes an envelope
    SEAL,           ///< key as Kenc, second as Kmac, nonce; bytes: a frame, becomes the sealed frame
    OPEN,        ///< key as Kenc, second as Kmac; bytes: a sealed frame; length becomes the content's, 0xFFFF if forged
    ADD_TO_CRC,  ///< length bytes; the CRC replaces the first two
    HEAR_PACKET,  ///< length bytes of payload as edges of the air; length becomes that of the payload received
    MEND_PACKET,  ///< length bytes of payload, of whose symbols each nonce[1]-th is wrong; after nonce[2] such packets, and of
    ///< the next one as many steps as nonce[0] says, measures the next step; length becomes what came of it
    ADD_PARITY,  ///< length bytes; their parity replaces the first 16
    ERASE,       ///< length bytes of a codeword; erases as many of the positions in `second` as `measured` says
    MEND_STEP,  ///< the same, then as many steps as nonce[0] says, and measures the next one; length becomes what came of it
    ANSWER  ///< length bytes of the line for a board; they become those of its last reply. Measured from the last
            ///< bytes, as many as `measured` says (0 for all), to that reply's first one
  };

  uint8_t operation;
  uint8_t measured;
  uint16_t length;
  uint8_t key[16];
  uint8_t second[16];
  uint8_t nonce[6];
  uint8_t bytes[600];
};

static_assert(sizeof(Mailbox) == 642, "no padding on either side");
