// SPDX-License-Identifier: GPL-3.0-or-later
// A board's first UART: joined to a pty, or written to the trace line by line.
#ifndef JAVINO_UART_H
#define JAVINO_UART_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "board.h"
#include "pty.h"

struct avr_irq_t;

#define UART_MAX_LINE 256

typedef struct {
  void *context;
  // A line without its end, or UART_MAX_LINE bytes of a longer one. NULL where there is a pty.
  void (*line)(void *context, const uint8_t *bytes, size_t length);
  // A byte has come from the host, or is on its way to it. NULL where there is no pty.
  void (*byte)(void *context, bool from_host, uint8_t byte);
} uart_listener;

typedef struct {
  const board *arduino;
  struct avr_irq_t *input;
  pty *port;  // NULL: lines go to the listener
  uart_listener listener;
  bool stopped;        // the UART takes no byte now
  cycles_t last_byte;  // when one came from the host, or began its way to it
  uint8_t line[UART_MAX_LINE];
  size_t line_length;
} uart;

// Joins UART 0 of the board to `port`, or where that is NULL to the listener.
void uart_init(uart *u, const board *arduino, pty *port, uart_listener listener);

// The chip was reset: nothing is sent to it before its program enables the receiver.
void uart_reset(uart *u);

// Passes on what the host has sent, as far as the UART takes it.
void uart_pump(uart *u);

// Hands over a line that has no end yet.
void uart_flush(uart *u);

#endif
