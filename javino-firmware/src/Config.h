#pragma once

#ifdef __AVR__
#include <avr/io.h>
#endif

/// The sizes of all that a board remembers, in two profiles. The large one fits an ATmega2560 (8 KiB of RAM, 4 KiB of
/// EEPROM), the small one an ATmega328P (2 KiB and 1 KiB). A chip with less than 4 KiB of RAM gets the small one, and so does
/// each with JAVINO_SMALL, here or by -D.
#if defined(JAVINO_SMALL) || (defined(RAMEND) && RAMEND < 0x1000)
#define JAVINO_LARGE 0
#define JAVINO_BY_PROFILE(large, small) small
#else
#define JAVINO_LARGE 1
#define JAVINO_BY_PROFILE(large, small) large
#endif

/// Keys in the EEPROM store, with next and previous ones, 1…63 (one reply lists them all). Each takes 3 bytes of RAM and
/// 44 of EEPROM, and so does one more place, where a new key is written before an old one is deleted.
#ifndef JAVINO_KEYS
#define JAVINO_KEYS JAVINO_BY_PROFILE(16, 6)
#endif

/// Session keys, which are in RAM only, 0…16 (SPEC 4.3, set session key). 40 bytes of RAM each, and 34 for frames without a key
/// (10 below 4). With 0 the command V is UNKNOWN_COMMAND, and the host is not told of frames without a key.
#ifndef JAVINO_SESSION_KEYS
#define JAVINO_SESSION_KEYS JAVINO_BY_PROFILE(8, 0)
#endif

/// Actions that a sketch can name, 1…254. 4 bytes of RAM each.
#ifndef JAVINO_ACTIONS
#define JAVINO_ACTIONS JAVINO_BY_PROFILE(16, 8)
#endif

/// Percepts with a dead band or a least interval of their own, and events, 1…254; further ones are told as they are. 11 bytes
/// of RAM each.
#ifndef JAVINO_DEAD_BANDS
#define JAVINO_DEAD_BANDS JAVINO_BY_PROFILE(8, 2)
#endif

#ifndef __ASSEMBLER__

#include <stdint.h>

namespace javinolib {

/// A number of bytes of a packet, and of what is in it. On a small board of one byte: 220 of flash less.
typedef JAVINO_BY_PROFILE(uint16_t, uint8_t) Length;

namespace config {

/// Whether the board has all of SPEC 6 and 7: it corrects more than one symbol of a packet, by copies and by parity, receives
/// messages in fragments, overhears and relays. A small one does none of that, and counts what it drops.
static const bool LARGE = JAVINO_LARGE;

static const uint8_t KEYS = JAVINO_KEYS;
static const uint8_t SESSION_KEYS = JAVINO_SESSION_KEYS;
static const uint8_t ACTIONS = JAVINO_ACTIONS;
static const uint8_t DEAD_BANDS = JAVINO_DEAD_BANDS;

/// The longest request and reply of a board without a radio, without header. A small one counts packets of up to 255 bytes.
static const uint16_t BOARD_MESSAGE = JAVINO_BY_PROFILE(511, 242);

/// The longest message (SPEC 2) that a board with a radio sends, receives and exchanges with its host; a content is 17 shorter.
static const uint16_t MAX_MESSAGE = JAVINO_BY_PROFILE(511, 84);

/// Bytes for received messages that wait for the host: each takes its content and 17 bytes more. The second of two messages that
/// come in fragments takes 521 of them while it comes.
static const uint16_t RECEIVE_BYTES = JAVINO_BY_PROFILE(640, 92);

/// Bytes for messages that wait for the air: each takes its content and 27 bytes more, a broadcast 13.
static const uint16_t TRANSMIT_BYTES = JAVINO_BY_PROFILE(640, 97);

/// Messages that can be under way at once, each to another device, so that one to a device that is absent does not hold up the
/// others (SPEC 7.2). 28 bytes each.
static const uint8_t PARTNERS = JAVINO_BY_PROFILE(4, 1);

/// How many times the board sends a multicast, and a broadcast: neither is acknowledged (SPEC 7.2).
static const uint8_t MULTICAST_SENDS = 2;
static const uint8_t BROADCAST_SENDS = 1;

/// Bytes for packets that were overheard, until the host has had them (SPEC 4.3): a packet takes its payload and 7 bytes more,
/// 84 at most.
static const uint16_t OVERHEARD_BYTES = JAVINO_BY_PROFILE(168, 0);

/// Radio packets that wait or are being received. 150 bytes each, 124 without parity.
static const uint8_t RADIO_PACKETS = 2;

/// Packets of which a copy is kept, damaged ones to be combined with the next copy, and right ones to know a damaged repeat.
/// 149 bytes each.
static const uint8_t DAMAGED_COPIES = JAVINO_BY_PROFILE(6, 0);

/// Acknowledgements that wait for the air. 13 bytes each.
static const uint8_t ACKNOWLEDGEMENTS = JAVINO_BY_PROFILE(6, 3);

/// The last broadcasts of all origins, so that repeats of them are known (SPEC 7.2). 6 bytes each.
static const uint8_t RECENT_BROADCASTS = JAVINO_BY_PROFILE(8, 3);

/// Origins, counted once for each key, whose last nonce is remembered. Each key of a pair has its own place; groups share the
/// others. 12 bytes each.
static const uint8_t REPLAY_ENTRIES = JAVINO_BY_PROFILE(24, 6);

/// Places of the ring with the floors of these nonces. 26 bytes of EEPROM each. The more of them are free, the longer the
/// EEPROM lasts: see ReplayMemory.h.
static const uint8_t FLOOR_SLOTS = JAVINO_BY_PROFILE(96, 18);

/// Places of the ring with the boot epoch, an even number. 6 bytes of EEPROM each; each lasts for 25 000 boots.
static const uint8_t EPOCH_SLOTS = 16;

/// A counter (SPEC 4.5), which stops at the greatest number that it can hold.
typedef JAVINO_BY_PROFILE(uint32_t, uint16_t) Count;

static_assert(KEYS >= 1 && KEYS <= 63, "JAVINO_KEYS must be 1…63");
static_assert(SESSION_KEYS <= 16, "JAVINO_SESSION_KEYS must be 0…16");
static_assert(8 * (KEYS + SESSION_KEYS) < MAX_MESSAGE, "JAVINO_KEYS, JAVINO_SESSION_KEYS: one reply lists all keys");
static_assert(REPLAY_ENTRIES >= KEYS, "JAVINO_KEYS: each has a place for nonces");
static_assert(ACTIONS >= 1 && ACTIONS <= 254, "JAVINO_ACTIONS must be 1…254");
static_assert(DEAD_BANDS >= 1 && DEAD_BANDS <= 254, "JAVINO_DEAD_BANDS must be 1…254");
static_assert(LARGE || (BOARD_MESSAGE <= 242 && MAX_MESSAGE <= 242), "a small board's packets have 255 bytes at most");
static_assert(LARGE || (RECEIVE_BYTES <= 255 && TRANSMIT_BYTES <= 255), "a small board's queues: 255 bytes at most");

}  // namespace config
}  // namespace javinolib

#endif
