// SPDX-License-Identifier: GPL-3.0-or-later
#include "eeprom.h"

#include <stdbool.h>
#include <string.h>

#include <simavr/avr_eeprom.h>
#include <simavr/sim_avr.h>
#include <simavr/sim_core.h>
#include <simavr/sim_time.h>

// Data space address of EECR, on the ATmega2560 and the ATmega328P alike.
#define CONTROL 0x3F
#define ERASED 0xFF
// EEMPE falls by itself so many cycles after it was set.
#define ARMED_CYCLES 4

enum { ERASE_AND_WRITE, ERASE_ONLY, WRITE_ONLY };

static avr_cycle_count_t disarm(struct avr_t *avr, avr_cycle_count_t when, void *context) {
  eeprom *e = context;
  (void)when;
  avr_regbit_clear(avr, e->part->eempe);
  return 0;
}

static void raise_if_enabled(eeprom *e) {
  if (avr_regbit_get(e->avr, e->part->ready.enable)) avr_raise_interrupt(e->avr, &e->part->ready);
}

static avr_cycle_count_t finish(struct avr_t *avr, avr_cycle_count_t when, void *context) {
  eeprom *e = context;
  (void)when;
  e->done_at = 0;
  avr_regbit_clear(avr, e->part->eepe);
  raise_if_enabled(e);
  return 0;
}

static uint16_t addressed(const eeprom *e) {
  const uint8_t *data = e->avr->data;
  return (uint16_t)((data[e->part->r_eearl] | data[e->part->r_eearh] << 8) % e->part->size);
}

static void begin_write(eeprom *e) {
  uint8_t data = e->avr->data[e->part->r_eedr];
  e->address = addressed(e);
  uint8_t *byte = &e->part->eeprom[e->address];
  e->before = *byte;
  e->mode = (uint8_t)avr_regbit_get_array(e->avr, e->part->eepm, 2);
  *byte = e->mode == ERASE_ONLY ? ERASED : e->mode == WRITE_ONLY ? *byte & data : data;
  avr_cycle_count_t duration =
      avr_usec_to_cycles(e->avr, e->mode == ERASE_AND_WRITE ? EEPROM_WRITE_US : EEPROM_SPLIT_US);
  e->done_at = e->avr->cycle + duration;
  avr_regbit_set(e->avr, e->part->eepe);
  avr_cycle_timer_register(e->avr, duration, finish, e);
  e->writes++;
  e->listener.written(e->listener.context, e->address, *byte);
}

static void control_written(struct avr_t *avr, avr_io_addr_t address, uint8_t value, void *context) {
  eeprom *e = context;
  const avr_eeprom_t *part = e->part;
  bool armed = avr_regbit_get(avr, part->eempe);
  bool enabled = avr_regbit_get(avr, part->ready.enable);
  avr->data[address] = value;
  bool write = armed && avr_regbit_get(avr, part->eepe);
  bool read = avr_regbit_get(avr, part->eere);
  avr_regbit_clear(avr, part->eere);
  if (e->done_at) {  // bars the next write, and reading
    avr_regbit_clear(avr, part->eempe);
    avr_regbit_set(avr, part->eepe);
    return;
  }
  avr_regbit_clear(avr, part->eepe);
  if (write)
    avr_regbit_clear(avr, part->eempe);
  else if (!armed && avr_regbit_get(avr, part->eempe))
    avr_cycle_timer_register(avr, ARMED_CYCLES, disarm, e);
  if (read) avr->data[part->r_eedr] = part->eeprom[addressed(e)];
  if (write)
    begin_write(e);
  else if (!enabled)
    raise_if_enabled(e);
}

void eeprom_init(eeprom *e, struct avr_t *avr, eeprom_listener listener) {
  memset(e, 0, sizeof *e);
  e->avr = avr;
  e->part = avr->io[AVR_DATA_TO_IO(CONTROL)].w.param;
  e->listener = listener;
  avr->io[AVR_DATA_TO_IO(CONTROL)].w.param = e;
  avr->io[AVR_DATA_TO_IO(CONTROL)].w.c = control_written;
}

void eeprom_load(eeprom *e, const uint8_t *bytes) { memcpy(e->part->eeprom, bytes, e->part->size); }

void eeprom_reset(eeprom *e) {
  if (!e->done_at) return;
  avr_cycle_count_t left = e->done_at > e->avr->cycle ? e->done_at - e->avr->cycle : 1;
  avr_regbit_set(e->avr, e->part->eepe);
  avr_cycle_timer_register(e->avr, left, finish, e);
}

int eeprom_tear(eeprom *e, prng *noise) {
  if (!e->done_at) return -1;
  uint64_t random = prng_next(noise);
  uint8_t bits = (uint8_t)random;
  uint8_t *byte = &e->part->eeprom[e->address];
  const uint8_t stages[] = {
      e->before,
      e->before | bits,  // erasing raises bits, one sooner than the other
      ERASED,
      *byte | bits,  // writing clears them
  };
  const uint8_t write_stages[] = {e->before, e->before & (*byte | bits)};
  switch (e->mode) {
    case ERASE_ONLY: *byte = stages[(random >> 32) % 3]; break;
    case WRITE_ONLY: *byte = write_stages[random >> 32 & 1]; break;
    default: *byte = stages[random >> 32 & 3]; break;
  }
  e->done_at = 0;
  return e->address;
}
