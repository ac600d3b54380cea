// SPDX-License-Identifier: GPL-3.0-or-later
// Events of the trace that a board's program causes: its trace points (javino-firmware, src/support/TracePoints.h), and
// the bytes that it writes to its EEPROM before each.
#ifndef JAVINO_POINT_LOG_H
#define JAVINO_POINT_LOG_H

#include <stddef.h>
#include <stdint.h>

#include "clock.h"
#include "trace.h"

// A loop that has nothing to do runs with each tick of the Arduino core's clock, every 16 384 cycles of the chip.
#define POINTS_LATE_CYCLES 40000

#define POINTS_LONGEST_RUN 64

typedef struct {
  trace *out;
  const char *board;
  const uint64_t *heard;  // the number of the last packet that has come to the board; 0 before the first
  cycles_t late;          // a run() that comes later than this after the one before is told
  cycles_t run;           // when the last run() began; NEVER before the first since a reset
  cycles_t gap;           // after the one before it
  uint8_t air;            // the point that it told
  int turn;               // the operand of the last TURN; -1 before the first
  uint16_t at;            // bytes of the EEPROM that were written one beside the other
  size_t length;
  uint8_t bytes[POINTS_LONGEST_RUN];
} point_log;

// `clock_cycles` of 16 MHz take a cycle of the board.
void point_log_init(point_log *p, trace *out, const char *board, const uint64_t *heard, unsigned clock_cycles);

// The board is reset: what it was about to write is not told, as it may be half of a key.
void point_log_reset(point_log *p);

// The program has written this number to GPIOR0; its operands are in the other two. 0 and what the list lacks is nothing.
void point_log_tell(point_log *p, uint8_t number, uint8_t first, uint8_t second, cycles_t now);

// The program writes a byte to the EEPROM.
void point_log_eeprom(point_log *p, uint16_t address, uint8_t byte, cycles_t now);

// Tells what is not told yet.
void point_log_flush(point_log *p, cycles_t now);

#endif
