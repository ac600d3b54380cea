// SPDX-License-Identifier: GPL-3.0-or-later
// One emulated Arduino: its chip with its firmware, its pins and its clock.
#ifndef JAVINO_BOARD_H
#define JAVINO_BOARD_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "clock.h"
#include "eeprom.h"
#include "model.h"
#include "prng.h"
#include "pwm.h"
#include "sleep.h"

struct avr_t;
struct avr_irq_t;

#define BOARD_PORTS 12  // 'A'…'L'

typedef enum { RESET_POWER, RESET_EXTERNAL, RESET_WATCHDOG } reset_cause;

typedef struct {
  void *context;
  // The board drives an observed pin to another level.
  void (*output)(void *context, int pin, bool level, cycles_t at);
  // The board has been reset, the power-on included.
  void (*reset)(void *context, reset_cause cause);
  // The program begins to write an EEPROM byte; board_stop may be called from here.
  void (*eeprom_written)(void *context, uint16_t address, uint8_t byte);
  // The program has written to GPIOR0; the others hold these.
  void (*point)(void *context, uint8_t number, uint8_t first, uint8_t second);
  // An observed pin has this duty, 0…1, by a timer; negative: it has the program's level again.
  void (*duty)(void *context, int pin, double duty, cycles_t at);
} board_listener;

// A level that an input pin will have.
typedef struct {
  cycles_t at;
  int pin;
  bool level;
} board_input;

typedef struct {
  const model *model;
  struct avr_t *avr;
  board_listener listener;
  eeprom memory;
  int clock_error_ppm;  // how much faster its clock runs; to be set before the power comes
  cycles_t limit;       // the chip runs up to here, in its own cycles
  bool powered;
  bool stopped;        // board_run returns after the instruction under way
  bool reset_pending;  // the chip was reset, its surroundings not yet told
  reset_cause cause;
  bool halted;  // sleeps with interrupts off: only a reset wakes it
  sleep_clocks sleep;
  pwm duties;
  struct {
    uint8_t direction, latch;  // DDRx and PORTx
    uint8_t observed;          // pins whose output is of interest
    uint8_t driven, external;  // pins driven from outside, and their levels
    struct board_port_link *link;
  } ports[BOARD_PORTS];
  board_input *inputs;  // still to come, latest first
  size_t input_count, input_capacity;
} board;

// Makes the chip and loads the firmware. The board is not running until board_power_on.
// Returns 0, or -1 with one line in `error`: no ELF file, or one for another chip.
int board_init(board *b, const model *m, const char *firmware, board_listener listener, char *error, size_t error_size);
void board_release(board *b);

// Reports changes of this pin's output level from now on.
void board_observe(board *b, int pin);

// The chip starts anew; registers and RAM hold anything.
void board_power_on(board *b, prng *noise);

// The power goes: pins float, and an EEPROM byte that is being written is torn. Time goes on.
// Returns the torn byte's address, or -1 when there is none.
int board_power_off(board *b, prng *noise);

// A reset without loss of power: RAM stays, as in a real chip. Nothing while there is no power.
void board_reset(board *b);

// Whether the board now drives the pin high.
bool board_output(const board *b, int pin);

// An input pin gets a level, now or at `at`.
void board_drive(board *b, int pin, bool level);
void board_drive_at(board *b, int pin, bool level, cycles_t at);

// Whether its UARTs work: not in a sleep mode that stops their clock, where bytes from outside are lost.
bool board_hears_bytes(const board *b);

// Lets board_run return before `until`, to be called again or to switch the power off.
void board_stop(board *b);

// Runs until the clock is at `until` or at most a few microseconds past it, or until board_stop.
// Returns 0, or -1 when the program has crashed.
int board_run(board *b, cycles_t until);

cycles_t board_now(const board *b);

// When the board has something to do next: its clock while it runs, later while it sleeps.
cycles_t board_next_event(const board *b);

// The program counter, in bytes.
uint32_t board_pc(const board *b);

#endif
