// SPDX-License-Identifier: GPL-3.0-or-later
#include "serial_module.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <simavr/avr_uart.h>
#include <simavr/sim_avr.h>

#include "serial_sniffer.h"

#define MODULE_STREAM 4000
#define BITS_ON_UART 10
#define BITS_ON_AIR 8
#define CRC_LENGTH 2
// Registers of an ATmega2560's UART 1, and how far its rate may be off.
#define UCSR1A 0xC8
#define UBRR1L 0xCC
#define U2X1 0x02
#define MAX_RATE_ERROR 0.03

static uint64_t bit_of(size_t index) { return (uint64_t)1 << index; }

static const module_config *kind(const serial_module *m) { return &m->owner->config->radio.module; }

static cycles_t byte_time(const serial_module *m) { return seconds_to_cycles(BITS_ON_UART / kind(m)->uart_rate); }

static bool on_air(const serial_module *m) { return m->piece_length > 0; }

static void tell_aux(serial_module *m) {
  if (m->aux_pin < 0) return;
  bool busy = m->waiting_count > 0 || on_air(m) || m->output_count > 0;
  board_drive(m->arduino, m->aux_pin, !busy);
}

static void take(serial_module *m, uint8_t byte, cycles_t at) {
  if (m->waiting_count == kind(m)->buffer) {
    m->lost++;
    return;
  }
  m->waiting[m->waiting_count++] = byte;
  m->last_byte = at;
  if (m->waiting_count == kind(m)->piece) m->full = at;
  tell_aux(m);
}

// Whether the board's UART has the module's rate.
static bool has_right_rate(const serial_module *m) {
  const struct avr_t *avr = m->arduino->avr;
  unsigned divisor = (unsigned)(avr->data[UBRR1L] | avr->data[UBRR1L + 1] << 8) + 1;
  double rate = (double)avr->frequency / ((avr->data[UCSR1A] & U2X1 ? 8 : 16) * divisor);
  return fabs(rate / kind(m)->uart_rate - 1) < MAX_RATE_ERROR;
}

// A byte at another rate than the module's comes as any byte.
static void byte_sent(struct avr_irq_t *irq, uint32_t value, void *context) {
  serial_module *m = context;
  (void)irq;
  if (!has_right_rate(m)) value = (uint32_t)prng_next(&m->errors);
  take(m, (uint8_t)value, board_now(m->arduino) + byte_time(m));
}

int serial_modules_init(serial_modules *s, const scenario *config, uint64_t seed, rf_bus *bus, sniffer *listener) {
  *s = (serial_modules){.config = config, .bus = bus, .listener = listener};
  if (!config->radio.module.name) return 0;
  s->modules = calloc(config->board_count + 1, sizeof *s->modules);
  if (!s->modules) return -1;
  s->count = config->board_count + 1;
  for (size_t i = 0; i < s->count; i++) {
    s->modules[i].owner = s;
    s->modules[i].index = i;
    s->modules[i].aux_pin = -1;
    prng_seed(&s->modules[i].errors, seed, MODULE_STREAM + i);
  }
  return 0;
}

void serial_modules_release(serial_modules *s) { free(s->modules); }

void serial_modules_join(serial_modules *s, size_t index, board *arduino) {
  if (!s->modules) return;
  serial_module *m = &s->modules[index];
  uint32_t flags = 0;
  m->arduino = arduino;
  m->aux_pin = s->config->boards[index].aux_pin;
  avr_ioctl(arduino->avr, AVR_IOCTL_UART_SET_FLAGS('1'), &flags);
  m->input = avr_io_getirq(arduino->avr, AVR_IOCTL_UART_GETIRQ('1'), UART_IRQ_INPUT);
  avr_irq_register_notify(avr_io_getirq(arduino->avr, AVR_IOCTL_UART_GETIRQ('1'), UART_IRQ_OUTPUT), byte_sent, m);
  tell_aux(m);
}

void serial_modules_power_off(serial_modules *s, size_t index) {
  if (!s->modules) return;
  s->modules[index].waiting_count = s->modules[index].output_count = 0;
  s->modules[index].missed = UINT64_MAX;
}

int serial_modules_inject(serial_modules *s, const injector_packet *packet, cycles_t now) {
  serial_module *m = &s->modules[s->count - 1];
  uint8_t bytes[MODULE_MAX_PACKET] = {0, (uint8_t)packet->path};
  size_t length = packet->length + 2;
  if (m->waiting_count + length + 4 > kind(m)->buffer) return -1;
  memcpy(bytes + 2, packet->payload, packet->length);
  uint16_t crc = crc_x25(bytes + 1, length - 1);
  bytes[length++] = (uint8_t)crc;
  bytes[length++] = (uint8_t)(crc >> 8);
  for (size_t i = length, next = length; i-- > 0;) {  // COBS: each zero becomes the distance to the next one
    if (bytes[i] != 0) continue;
    bytes[i] = (uint8_t)(next - i);
    next = i;
  }
  rf_bus_move(s->bus, m->index, packet->x_m, packet->y_m, now);
  take(m, 0, now);
  for (size_t i = 0; i < length; i++) take(m, bytes[i], now);
  take(m, 0, now);
  return 0;
}

void serial_modules_collision(serial_modules *s, size_t receiver, uint64_t sources) {
  for (size_t i = 0; i < s->count; i++)
    if (sources & bit_of(i)) s->modules[i].missed |= bit_of(receiver);
}

static cycles_t next_start(const serial_module *m) {
  if (m->waiting_count == 0) return NEVER;
  cycles_t pause = seconds_to_cycles(kind(m)->pause_s);
  return (m->waiting_count >= kind(m)->piece ? m->full : m->last_byte + pause) + seconds_to_cycles(kind(m)->delay_s);
}

static void begin(serial_modules *s, serial_module *m, cycles_t at) {
  size_t piece = kind(m)->piece;
  m->piece_length = m->waiting_count < piece ? m->waiting_count : piece;
  memcpy(m->piece, m->waiting, m->piece_length);
  m->waiting_count -= m->piece_length;
  memmove(m->waiting, m->waiting + m->piece_length, m->waiting_count);
  m->full = at;
  m->start = at;
  m->end = at + seconds_to_cycles(kind(m)->lead_s + (double)(BITS_ON_AIR * m->piece_length) / kind(m)->air_rate);
  m->missed = 0;
  for (size_t i = 0; i < s->count; i++) {  // a module that sends hears nothing
    if (!on_air(&s->modules[i])) continue;
    m->missed |= bit_of(i);
    s->modules[i].missed |= bit_of(m->index);
  }
  rf_bus_carrier(s->bus, m->index, true, at);
  rf_bus_carrier(s->bus, m->index, false, m->end);
}

void serial_modules_send(serial_modules *s, cycles_t now, cycles_t until) {
  for (size_t i = 0; i < s->count; i++) {
    serial_module *m = &s->modules[i];
    cycles_t start = next_start(m);
    if (!on_air(m) && start < until) begin(s, m, start < now ? now : start);
  }
}

static void output(serial_module *m, const uint8_t *bytes, size_t length, cycles_t at) {
  size_t room = kind(m)->buffer - m->output_count;
  size_t kept = length < room ? length : room;
  m->lost += length - kept;
  if (m->output_count == 0) m->next_output = at + byte_time(m);
  memcpy(m->output + m->output_count, bytes, kept);
  m->output_count += kept;
  tell_aux(m);
}

// Each bit and each whole piece may be lost by chance.
static bool is_lost(serial_module *m, size_t length) {
  const radio_config *radio = &m->owner->bus->radio;
  double bits = 1 - pow(1 - radio->bit_error_rate, (double)(BITS_ON_AIR * length));
  return prng_chance(&m->errors, radio->loss + bits - radio->loss * bits);
}

// Tells a packet of SPEC 6.2 that has been on the air whole.
static void tell_packet(serial_module *m) {
  int length = m->packet_length > MODULE_MAX_PACKET ? -1 : serial_unstuff(m->packet, m->packet_length);
  line_packet packet = {
      .bits = (unsigned)(BITS_ON_AIR * (m->packet_length + 2)), .start = m->packet_start, .end = m->end};
  if (length > 1 + CRC_LENGTH) {
    size_t checked = (size_t)length - CRC_LENGTH;
    uint16_t crc = (uint16_t)(m->packet[checked] | m->packet[checked + 1] << 8);
    packet.payload = m->packet + 1;
    packet.path = m->packet[0];
    if (crc == crc_x25(m->packet, checked) && packet.path < LINE_PATHS) packet.length = checked - 1;
  }
  sniffer_module_packet(m->owner->listener, m->index, &packet, m->packet_missed);
}

static void sniff(serial_module *m) {
  m->packet_missed |= m->missed;
  for (size_t i = 0; i < m->piece_length; i++) {
    if (m->piece[i] != 0) {
      if (m->packet_length == 0) m->packet_start = m->start;
      if (m->packet_length <= MODULE_MAX_PACKET) m->packet[m->packet_length++] = m->piece[i];
    } else if (m->packet_length > 0) {
      tell_packet(m);
      m->packet_length = 0;
      m->packet_missed = m->missed;
    }
  }
  if (m->packet_length == 0) m->packet_missed = 0;
}

static void end(serial_modules *s, serial_module *m) {
  for (size_t i = 0; i + 1 < s->count; i++) {
    if (!rf_bus_hears(s->bus, i, m->index)) continue;
    if (is_lost(&s->modules[i], m->piece_length)) m->missed |= bit_of(i);
    if (!(m->missed & bit_of(i)) && s->modules[i].arduino->powered)
      output(&s->modules[i], m->piece, m->piece_length, m->end);
  }
  sniff(m);
  m->piece_length = 0;
  tell_aux(m);
}

void serial_modules_receive(serial_modules *s, cycles_t until) {
  for (size_t i = 0; i < s->count; i++) {
    serial_module *m = &s->modules[i];
    if (on_air(m) && m->end < until) end(s, m);
    while (m->output_count > 0 && m->next_output < until) {
      if (board_hears_bytes(m->arduino)) avr_raise_irq(m->input, m->output[0]);
      memmove(m->output, m->output + 1, --m->output_count);
      m->next_output += byte_time(m);
      tell_aux(m);
    }
  }
}

cycles_t serial_modules_next(const serial_modules *s) {
  cycles_t next = NEVER;
  for (size_t i = 0; i < s->count; i++) {
    const serial_module *m = &s->modules[i];
    cycles_t own = on_air(m) ? m->end : next_start(m);
    if (m->output_count > 0 && m->next_output < own) own = m->next_output;
    if (own < next) next = own;
  }
  return next;
}
