// SPDX-License-Identifier: GPL-3.0-or-later
#include "uart.h"

#include <string.h>

#include <simavr/avr_uart.h>
#include <simavr/sim_avr.h>

static void line_byte(uart *u, uint8_t byte) {
  if (byte != '\n' && byte != '\r') u->line[u->line_length++] = byte;
  if (byte == '\n' || u->line_length == UART_MAX_LINE) uart_flush(u);
}

static void byte_sent(struct avr_irq_t *irq, uint32_t value, void *context) {
  uart *u = context;
  (void)irq;
  if (!u->port) {
    line_byte(u, (uint8_t)value);
    return;
  }
  u->last_byte = board_now(u->arduino);
  u->listener.byte(u->listener.context, false, (uint8_t)value);
  pty_put(u->port, (uint8_t)value, u->last_byte);
}

static void ready(struct avr_irq_t *irq, uint32_t value, void *context) {
  uart *u = context;
  (void)irq;
  (void)value;
  u->stopped = false;
  uart_pump(u);
}

static void full(struct avr_irq_t *irq, uint32_t value, void *context) {
  uart *u = context;
  (void)irq;
  if (value) u->stopped = true;
}

void uart_init(uart *u, const board *arduino, pty *port, uart_listener listener) {
  struct avr_t *avr = arduino->avr;
  uint32_t flags = 0;  // neither printing to our own output nor waiting when the program polls
  memset(u, 0, sizeof *u);
  u->arduino = arduino;
  u->port = port;
  u->listener = listener;
  u->stopped = true;
  avr_ioctl(avr, AVR_IOCTL_UART_SET_FLAGS('0'), &flags);
  u->input = avr_io_getirq(avr, AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_INPUT);
  avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_OUTPUT), byte_sent, u);
  avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_OUT_XON), ready, u);
  avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_OUT_XOFF), full, u);
}

void uart_reset(uart *u) {
  u->stopped = true;
  uart_flush(u);
}

void uart_pump(uart *u) {
  uint8_t byte;
  while (u->port && (!u->stopped || !board_hears_bytes(u->arduino)) && pty_take(u->port, &byte)) {
    u->last_byte = board_now(u->arduino);
    u->listener.byte(u->listener.context, true, byte);
    if (board_hears_bytes(u->arduino)) avr_raise_irq(u->input, byte);
  }
}

void uart_flush(uart *u) {
  if (u->line_length > 0) u->listener.line(u->listener.context, u->line, u->line_length);
  u->line_length = 0;
}
