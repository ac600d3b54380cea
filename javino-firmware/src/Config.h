#pragma once

#ifdef __AVR__
#include <avr/io.h>
#endif

/// The sizes of all that a board remembers. -D on the compiler's command line sets each of them. If there are two
/// defaults, the first fits an ATmega2560 (8 KiB of RAM, 4 KiB of EEPROM), the second an ATmega328P (2 KiB and 1 KiB).
/// Each comment says the cost in RAM.
#if defined(JAVINO_SMALL) || (defined(RAMEND) && RAMEND < 0x1000)
#define JAVINO_BY_CHIP(large, small) small
#else
#define JAVINO_BY_CHIP(large, small) large
#endif

/// Keys in the EEPROM store, with next and previous ones, 1…63 (one reply lists them all). Each takes 4 bytes of RAM and
/// 44 of EEPROM, and so does one more place, where a new key is written before an old one is deleted.
#ifndef JAVINO_KEYS
#define JAVINO_KEYS JAVINO_BY_CHIP(16, 6)
#endif

/// Session keys, which are in RAM only, 0…16 (SPEC 4.3, set session key). 40 bytes of RAM each, and 34 for frames without a key
/// (10 below 4). With 0 the command V is UNKNOWN_COMMAND, and the host is not told of frames without a key.
#ifndef JAVINO_SESSION_KEYS
#define JAVINO_SESSION_KEYS JAVINO_BY_CHIP(8, 0)
#endif

/// Origins, counted once for each key, whose last nonce is remembered: at least as many as keys, at most 253. Each key of
/// a pair has its own place; groups share the others. 13 bytes of RAM each.
#ifndef JAVINO_REPLAY_ENTRIES
#define JAVINO_REPLAY_ENTRIES JAVINO_BY_CHIP(24, 6)
#endif

/// Places of the ring with the floors of these nonces: more than the entries above, at most 254. 26 bytes of EEPROM
/// each. The more of them are free, the longer the EEPROM lasts: see ReplayMemory.h.
#ifndef JAVINO_FLOOR_SLOTS
#define JAVINO_FLOOR_SLOTS JAVINO_BY_CHIP(96, 23)
#endif

/// The longest message (SPEC 2) that the board sends, receives and exchanges with its host, 84…511 bytes; a content is
/// 17 shorter. It sets the size of two packets of the serial line, of each half-received message, and the least size
/// of the two queues below.
#ifndef JAVINO_MAX_MESSAGE
#define JAVINO_MAX_MESSAGE JAVINO_BY_CHIP(511, 84)
#endif

/// Bytes of RAM for received messages that wait for the host: each takes its content and 17 bytes more.
#ifndef JAVINO_RECEIVE_BYTES
#define JAVINO_RECEIVE_BYTES JAVINO_BY_CHIP(640, 92)
#endif

/// Bytes of RAM for messages that wait for the air: each takes its content and 27 bytes more, a broadcast 13.
#ifndef JAVINO_TRANSMIT_BYTES
#define JAVINO_TRANSMIT_BYTES JAVINO_BY_CHIP(640, 97)
#endif

/// Messages that can be under way at once, each to another device, 1…8, so that one to a device that is absent does not
/// hold up the others (SPEC 7.2). 28 bytes of RAM each.
#ifndef JAVINO_PARTNERS
#define JAVINO_PARTNERS JAVINO_BY_CHIP(4, 1)
#endif

/// Messages in pieces that can be received at the same time, 0…8. RAM: the longest message and 172 bytes each. With 0,
/// the board drops and counts all that does not fit one packet: a sealed content of more than 53 bytes, a broadcast of
/// more than 67.
#ifndef JAVINO_REASSEMBLIES
#define JAVINO_REASSEMBLIES JAVINO_BY_CHIP(2, 0)
#endif

/// How many times the board sends a multicast, and a broadcast, 1…4: neither is acknowledged (SPEC 7.2). No RAM.
#ifndef JAVINO_MULTICAST_SENDS
#define JAVINO_MULTICAST_SENDS 2
#endif
#ifndef JAVINO_BROADCAST_SENDS
#define JAVINO_BROADCAST_SENDS 1
#endif

/// Bytes of RAM for packets that were overheard, until the host has had them (SPEC 4.3): a packet takes its payload and 7
/// bytes more, 84 at most. With 0 the board neither overhears nor relays: the commands O and Y are UNKNOWN_COMMAND.
#ifndef JAVINO_OVERHEARD_BYTES
#define JAVINO_OVERHEARD_BYTES JAVINO_BY_CHIP(256, 0)
#endif

/// Whether a host can make the board a relay, 0 or 1 (SPEC 7.5): 24 bytes of RAM, as a relay's memory is the place of one of
/// JAVINO_REASSEMBLIES. With 0 the command W is UNKNOWN_COMMAND; a sketch's own javinolib::Relay does not depend on it.
#ifndef JAVINO_RELAY
#define JAVINO_RELAY (JAVINO_REASSEMBLIES > 0 && JAVINO_BY_CHIP(1, 0))
#endif

/// Radio packets that wait or are being received, 2…8. 150 bytes of RAM each, 124 without parity.
#ifndef JAVINO_RADIO_PACKETS
#define JAVINO_RADIO_PACKETS JAVINO_BY_CHIP(3, 2)
#endif

/// Whether more than one wrong symbol of a packet is mended, and wrong bits of an expected acknowledgement are borne, 0 or 1
/// (SPEC 6, 7.3). 30 bytes of RAM.
#ifndef JAVINO_MENDING
#define JAVINO_MENDING JAVINO_BY_CHIP(1, 0)
#endif

/// Packets of which a copy is kept, damaged ones to be combined with the next copy, and right ones to know a damaged repeat,
/// 0…16. 149 bytes of RAM each, 123 without parity.
#ifndef JAVINO_DAMAGED_COPIES
#define JAVINO_DAMAGED_COPIES JAVINO_BY_CHIP(6, 0)
#endif

/// Acknowledgements that wait for the air, 2…16. 13 bytes of RAM each.
#ifndef JAVINO_ACKNOWLEDGEMENTS
#define JAVINO_ACKNOWLEDGEMENTS JAVINO_BY_CHIP(6, 3)
#endif

/// Origins whose last broadcast is remembered, so that a repeat of it is known (SPEC 7.2), 1…16. 10 bytes of RAM each.
#ifndef JAVINO_BROADCAST_ORIGINS
#define JAVINO_BROADCAST_ORIGINS JAVINO_BY_CHIP(4, 2)
#endif

/// Actions that a sketch can name, 0…254. 4 bytes of RAM each. With 0 each one is UNKNOWN_ACTION.
#ifndef JAVINO_ACTIONS
#define JAVINO_ACTIONS JAVINO_BY_CHIP(16, 8)
#endif

/// Percepts with a dead band or a least interval of their own, 0…254; further ones are told as they are. 11 bytes of RAM
/// each.
#ifndef JAVINO_DEAD_BANDS
#define JAVINO_DEAD_BANDS JAVINO_BY_CHIP(8, 2)
#endif

/// Whether keys can be renewed, 0 or 1 (SPEC 4.3). With 0 the commands N, U and F are UNKNOWN_COMMAND, and a key can only be
/// replaced at once.
#ifndef JAVINO_KEY_RENEWAL
#define JAVINO_KEY_RENEWAL 1
#endif

/// Whether packets get parity behind them when it is needed, and are mended by it, 0 or 1 (SPEC 6.1).
#ifndef JAVINO_PARITY
#define JAVINO_PARITY JAVINO_BY_CHIP(1, 0)
#endif

/// Whether what the board does and drops is counted, 0 or 1: 100 bytes of RAM. With 0 the command S is UNKNOWN_COMMAND.
#ifndef JAVINO_STATISTICS
#define JAVINO_STATISTICS 1
#endif

/// Places of the ring with the boot epoch, 4…64, an even number. 6 bytes of EEPROM each; each lasts for 25 000 boots.
#ifndef JAVINO_EPOCH_SLOTS
#define JAVINO_EPOCH_SLOTS 16
#endif

/// The first byte of EEPROM that Javino uses; the README has the layout.
#ifndef JAVINO_EEPROM_START
#define JAVINO_EEPROM_START 0
#endif

/// Whether all round keys of an AES key are computed before its first block, 0 or 1. With 0 each block computes them anew: on
/// an ATmega it takes 3270 cycles then instead of 2000, but 144 bytes less of the stack and 160 of flash.
#ifndef JAVINO_ROUND_KEYS
#define JAVINO_ROUND_KEYS JAVINO_BY_CHIP(1, 0)
#endif

#ifndef __ASSEMBLER__

#include <stdint.h>

namespace javinolib {
namespace config {

static const uint8_t KEYS = JAVINO_KEYS;
static const uint8_t SESSION_KEYS = JAVINO_SESSION_KEYS;
static const uint8_t REPLAY_ENTRIES = JAVINO_REPLAY_ENTRIES;
static const uint8_t FLOOR_SLOTS = JAVINO_FLOOR_SLOTS;
static const uint16_t MAX_MESSAGE = JAVINO_MAX_MESSAGE;
static const uint16_t RECEIVE_BYTES = JAVINO_RECEIVE_BYTES;
static const uint16_t TRANSMIT_BYTES = JAVINO_TRANSMIT_BYTES;
static const uint8_t PARTNERS = JAVINO_PARTNERS;
static const uint8_t REASSEMBLIES = JAVINO_REASSEMBLIES;
static const uint8_t MULTICAST_SENDS = JAVINO_MULTICAST_SENDS;
static const uint8_t BROADCAST_SENDS = JAVINO_BROADCAST_SENDS;
static const uint16_t OVERHEARD_BYTES = JAVINO_OVERHEARD_BYTES;
static const bool RELAY = JAVINO_RELAY;
static const uint8_t RADIO_PACKETS = JAVINO_RADIO_PACKETS;
static const bool MENDING = JAVINO_MENDING;
static const uint8_t DAMAGED_COPIES = JAVINO_DAMAGED_COPIES;
static const uint8_t ACKNOWLEDGEMENTS = JAVINO_ACKNOWLEDGEMENTS;
static const uint8_t BROADCAST_ORIGINS = JAVINO_BROADCAST_ORIGINS;
static const uint8_t ACTIONS = JAVINO_ACTIONS;
static const uint8_t DEAD_BANDS = JAVINO_DEAD_BANDS;
static const bool KEY_RENEWAL = JAVINO_KEY_RENEWAL;
static const bool PARITY = JAVINO_PARITY;
static const bool STATISTICS = JAVINO_STATISTICS;
static const uint8_t EPOCH_SLOTS = JAVINO_EPOCH_SLOTS;
static const uint16_t EEPROM_START = JAVINO_EEPROM_START;

static_assert(JAVINO_KEYS >= 1 && JAVINO_KEYS <= 63, "JAVINO_KEYS must be 1…63");
static_assert(JAVINO_SESSION_KEYS >= 0 && JAVINO_SESSION_KEYS <= 16, "JAVINO_SESSION_KEYS must be 0…16");
static_assert(8 * (JAVINO_KEYS + JAVINO_SESSION_KEYS) < JAVINO_MAX_MESSAGE,
              "JAVINO_KEYS, JAVINO_SESSION_KEYS: one reply of JAVINO_MAX_MESSAGE bytes lists all keys");
static_assert(JAVINO_REPLAY_ENTRIES >= JAVINO_KEYS && JAVINO_REPLAY_ENTRIES <= 253,
              "JAVINO_REPLAY_ENTRIES must be JAVINO_KEYS at least, and at most 253");
static_assert(JAVINO_FLOOR_SLOTS > JAVINO_REPLAY_ENTRIES && JAVINO_FLOOR_SLOTS <= 254,
              "JAVINO_FLOOR_SLOTS must be greater than JAVINO_REPLAY_ENTRIES, and at most 254");
// A board must be able to receive any single radio packet, and to tell its host the outcomes of 8 transmissions.
static_assert(JAVINO_MAX_MESSAGE >= 84 && JAVINO_MAX_MESSAGE <= 511, "JAVINO_MAX_MESSAGE must be 84…511");
static_assert(JAVINO_RECEIVE_BYTES >= JAVINO_MAX_MESSAGE + 3 && JAVINO_RECEIVE_BYTES <= 4096,
              "JAVINO_RECEIVE_BYTES must hold the longest message and 3 bytes, and be at most 4096");
static_assert(JAVINO_TRANSMIT_BYTES >= JAVINO_MAX_MESSAGE + 13 && JAVINO_TRANSMIT_BYTES <= 4096,
              "JAVINO_TRANSMIT_BYTES must hold the longest frame and 3 bytes, and be at most 4096");
static_assert(JAVINO_PARTNERS >= 1 && JAVINO_PARTNERS <= 8, "JAVINO_PARTNERS must be 1…8");
static_assert(JAVINO_REASSEMBLIES >= 0 && JAVINO_REASSEMBLIES <= 8, "JAVINO_REASSEMBLIES must be 0…8");
static_assert(JAVINO_OVERHEARD_BYTES == 0 || (JAVINO_OVERHEARD_BYTES >= 84 && JAVINO_OVERHEARD_BYTES <= 4096),
              "JAVINO_OVERHEARD_BYTES must be 0, or hold the longest packet: 84…4096");
static_assert(JAVINO_OVERHEARD_BYTES == 0 || JAVINO_MAX_MESSAGE >= 87,
              "JAVINO_OVERHEARD_BYTES: a reply of JAVINO_MAX_MESSAGE bytes tells the longest packet, 87 at least");
static_assert(JAVINO_RELAY == 0 || JAVINO_RELAY == 1, "JAVINO_RELAY must be 0 or 1");
static_assert(JAVINO_RELAY == 0 || JAVINO_REASSEMBLIES > 0,
              "JAVINO_RELAY takes the place of one of JAVINO_REASSEMBLIES");
static_assert(JAVINO_RADIO_PACKETS >= 2 && JAVINO_RADIO_PACKETS <= 8, "JAVINO_RADIO_PACKETS must be 2…8");
static_assert(JAVINO_MENDING == 0 || JAVINO_MENDING == 1, "JAVINO_MENDING must be 0 or 1");
static_assert(JAVINO_MENDING == 1 || (JAVINO_PARITY == 0 && JAVINO_DAMAGED_COPIES == 0),
              "JAVINO_PARITY and JAVINO_DAMAGED_COPIES need JAVINO_MENDING");
static_assert(JAVINO_DAMAGED_COPIES >= 0 && JAVINO_DAMAGED_COPIES <= 16, "JAVINO_DAMAGED_COPIES must be 0…16");
static_assert(JAVINO_ACKNOWLEDGEMENTS >= 2 && JAVINO_ACKNOWLEDGEMENTS <= 16, "JAVINO_ACKNOWLEDGEMENTS must be 2…16");
static_assert(JAVINO_MULTICAST_SENDS >= 1 && JAVINO_MULTICAST_SENDS <= 4, "JAVINO_MULTICAST_SENDS must be 1…4");
static_assert(JAVINO_BROADCAST_SENDS >= 1 && JAVINO_BROADCAST_SENDS <= 4, "JAVINO_BROADCAST_SENDS must be 1…4");
static_assert(JAVINO_DEAD_BANDS >= 0 && JAVINO_DEAD_BANDS <= 254, "JAVINO_DEAD_BANDS must be 0…254");
static_assert(JAVINO_BROADCAST_ORIGINS >= 1 && JAVINO_BROADCAST_ORIGINS <= 16, "JAVINO_BROADCAST_ORIGINS must be 1…16");
static_assert(JAVINO_ACTIONS >= 0 && JAVINO_ACTIONS <= 254, "JAVINO_ACTIONS must be 0…254");
static_assert(JAVINO_KEY_RENEWAL == 0 || JAVINO_KEY_RENEWAL == 1, "JAVINO_KEY_RENEWAL must be 0 or 1");
static_assert(JAVINO_PARITY == 0 || JAVINO_PARITY == 1, "JAVINO_PARITY must be 0 or 1");
static_assert(JAVINO_STATISTICS == 0 || JAVINO_STATISTICS == 1, "JAVINO_STATISTICS must be 0 or 1");
static_assert(JAVINO_ROUND_KEYS == 0 || JAVINO_ROUND_KEYS == 1, "JAVINO_ROUND_KEYS must be 0 or 1");
static_assert(JAVINO_EPOCH_SLOTS >= 4 && JAVINO_EPOCH_SLOTS <= 64 && JAVINO_EPOCH_SLOTS % 2 == 0,
              "JAVINO_EPOCH_SLOTS must be 4…64, and even");

}  // namespace config
}  // namespace javinolib

#endif
