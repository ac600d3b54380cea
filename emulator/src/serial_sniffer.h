// SPDX-License-Identifier: GPL-3.0-or-later
// Listens to a board's serial line (SPEC section 4) and writes down what its host has it send, what is handed to the host,
// how transmissions ended, what the board perceives and is to do, and what the host changes: host-id, host-key, host-action, host-radio, host-relaying,
// host-transmit, host-relay, host-handed, host-no-key, host-taking, host-taken, host-outcome, host-nothing and percepts events.
// Keys that the host gives go to a file of their own.
#ifndef JAVINO_SERIAL_SNIFFER_H
#define JAVINO_SERIAL_SNIFFER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include "clock.h"
#include "trace.h"

// The longest packet on the line, without its closing 0x00.
#define SERIAL_MAX_PACKET 527
// The longest message of a frame.
#define SERIAL_MAX_MESSAGE 511
#define SERIAL_EPOCH_LENGTH 3

// The bytes of a packet, as they come.
typedef struct {
  uint8_t bytes[SERIAL_MAX_PACKET];
  size_t length;           // more than SERIAL_MAX_PACKET: too long
  cycles_t first, second;  // when these bytes of it came
} serial_line;

typedef struct {
  uint8_t sequence;
  uint16_t crc;
  char command;                        // 0: a frame to be transmitted
  bool repeats;                        // a poll that is the one before, byte by byte
  bool forgets;                        // a poll at which the board deletes what it told; it has not answered it
  int taken;                           // of a poll that says something new, or -1
  uint8_t address[4];                  // that becomes the RF id, has a key, or is to be sent to
  bool open;                           // of a request for the radio
  uint8_t epoch[SERIAL_EPOCH_LENGTH];  // that the boot epoch is to be raised to
  cycles_t at;
  uint8_t content[SERIAL_MAX_MESSAGE];  // that is to be sent, relayed, or done
  size_t content_length;
} serial_request;

typedef struct {
  trace *out;
  FILE *keys;  // NULL: they are not written
  const char *board;
  uint8_t id[4];  // the RF id, `++++` as long as it was not told
  uint8_t epoch[SERIAL_EPOCH_LENGTH];
  bool unicasts_only;  // it has sealed unicasts only, as it said at hello
  serial_line from_host, from_board;
  serial_request request;  // the last one
  bool waiting;            // it has no reply yet
  serial_request held;     // a poll before it
  bool held_waiting;       // that has no reply yet
  bool remembered;         // the board answers its repeats from memory
  uint16_t reply_crc;      // of its last reply
  bool told[256];          // by number of a message: its outcome was told, and the host is not known to have it
  bool tells_again;        // it was greeted, and deletes nothing at the next poll
  bool greeted;            // the board performs requests
  int taken;               // the last message that the board knows to be taken, or -1
} serial_sniffer;

// `out` and `board` must outlive the sniffer.
void serial_sniffer_init(serial_sniffer *s, trace *out, const char *board);

// The board has begun anew.
void serial_sniffer_reset(serial_sniffer *s);

// A byte has reached the board, or left it.
void serial_sniffer_byte(serial_sniffer *s, bool from_host, uint8_t byte, cycles_t at);

// Undoes COBS in place. Returns the length, or -1 where it is wrong.
int serial_unstuff(uint8_t *bytes, size_t length);

#endif
