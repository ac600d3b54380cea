// SPDX-License-Identifier: GPL-3.0-or-later
// Modules that carry bytes from UART to UART: in place of the ASK pair each board has one at its UART 1.
//
// On the air a piece of bytes is a carrier of the bus, which tells who is in range and what overlaps. A piece that was damaged
// anywhere does not come: the modules check it.
#ifndef JAVINO_SERIAL_MODULE_H
#define JAVINO_SERIAL_MODULE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "board.h"
#include "injector.h"
#include "prng.h"
#include "rf_bus.h"
#include "scenario.h"
#include "sniffer.h"

// A packet of SPEC 6.2, without its zeros.
#define MODULE_MAX_PACKET (1 + 1 + LINE_MAX_PAYLOAD + 2)

struct avr_irq_t;

typedef struct {
  struct serial_modules *owner;
  size_t index;
  board *arduino;  // NULL: the injector's
  int aux_pin;     // -1: none
  struct avr_irq_t *input;
  uint8_t waiting[MODULE_MAX_BUFFER];  // for the air
  size_t waiting_count;
  cycles_t last_byte;  // when it came
  cycles_t full;       // when a whole piece was there
  uint8_t piece[MODULE_MAX_PIECE];
  size_t piece_length;  // 0: nothing is on the air
  cycles_t start, end;
  uint64_t missed;                    // bit n: board n does not get the piece
  uint8_t output[MODULE_MAX_BUFFER];  // for the board
  size_t output_count;
  cycles_t next_output;
  uint64_t lost;  // bytes for which a buffer had no room
  prng errors;
  uint8_t packet[MODULE_MAX_PACKET + 1];  // that was sent so far; one byte more: it was too long
  size_t packet_length;
  cycles_t packet_start;
  uint64_t packet_missed;
} serial_module;

typedef struct serial_modules {
  const scenario *config;
  rf_bus *bus;
  sniffer *listener;
  serial_module *modules;  // of the boards, then the injector's; NULL: there are none
  size_t count;
} serial_modules;

// Returns 0, or -1 where the memory does not suffice. Without modules in the scenario, all below does nothing.
int serial_modules_init(serial_modules *s, const scenario *config, uint64_t seed, rf_bus *bus, sniffer *listener);
void serial_modules_release(serial_modules *s);

// Joins a module to UART 1 of its board, and to its AUX pin.
void serial_modules_join(serial_modules *s, size_t index, board *arduino);

// The board's power goes, and the module's with it.
void serial_modules_power_off(serial_modules *s, size_t index);

// Puts a packet on the air from the injector's place. Returns 0, or -1 while too many wait.
int serial_modules_inject(serial_modules *s, const injector_packet *packet, cycles_t now);

// Transmissions overlap at a receiver; bit n of `sources` is source n.
void serial_modules_collision(serial_modules *s, size_t receiver, uint64_t sources);

// Does what begins and ends on the air before `until`; then, when the bus has played it, takes what has come.
void serial_modules_send(serial_modules *s, cycles_t now, cycles_t until);
void serial_modules_receive(serial_modules *s, cycles_t until);

// When a module has something to do next.
cycles_t serial_modules_next(const serial_modules *s);

#endif
