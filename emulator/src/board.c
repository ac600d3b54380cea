// SPDX-License-Identifier: GPL-3.0-or-later
#include "board.h"

#include <stdlib.h>
#include <string.h>

#include <simavr/avr_ioport.h>
#include <simavr/avr_timer.h>
#include <simavr/sim_avr.h>
#include <simavr/sim_core.h>

#include "firmware.h"

// simavr may run so many cycles between two looks at the clock; bounds the overrun of board_run.
#define RUN_LIMIT 64
// r0…r31 lie at the start of the data space.
#define REGISTERS 32

// The mode bits of phase-correct PWM, 8 bits: 1 on all timers; 9 and 10 bits: 2 and 3 on those of
// 16 bits, where 8-bit timers have other modes that simavr knows (ATmega2560 data sheet,
// tables 16-8 and 17-2).
#define FIRST_MODE 1
#define LAST_MODE 3
#define FIRST_WIDTH 8

// Data space addresses, on the ATmega2560 and the ATmega328P alike.
#define GPIOR0 0x3E
#define GPIOR1 0x4A
#define GPIOR2 0x4B
#define WDTCSR 0x60
#define WDIE 0x40
#define WDE 0x08

// The context that simavr hands back when a port register changes.
struct board_port_link {
  board *owner;
  int index;
};

#define MILLION 1000000
// The product of cycles and millionths would be too large after 12 days.
typedef unsigned __int128 long_cycles_t;

// The chip's own cycles in those of the common clock, and the reverse, up to the next one. Whole numbers make both exact:
// on_chip gives the first cycle that is not before a time.
static cycles_t on_clock(const board *b, avr_cycle_count_t own) {
  cycles_t common = own * b->model->clock_cycles;
  if (__builtin_expect(b->clock_error_ppm == 0, 1)) return common;
  return (cycles_t)((long_cycles_t)common * MILLION / (unsigned)(MILLION + b->clock_error_ppm));
}

static avr_cycle_count_t on_chip(const board *b, cycles_t common) {
  unsigned own_cycles = b->model->clock_cycles;
  if (b->clock_error_ppm == 0) return (common + own_cycles - 1) / own_cycles;
  unsigned divisor = own_cycles * MILLION;
  return (avr_cycle_count_t)(((long_cycles_t)common * (unsigned)(MILLION + b->clock_error_ppm) + divisor - 1) /
                             divisor);
}

static int port_index(char port) { return port - 'A'; }

static struct avr_irq_t *port_irq(const board *b, int index, int which) {
  return avr_io_getirq(b->avr, (uint32_t)AVR_IOCTL_IOPORT_GETIRQ('A' + index), which);
}

// Tells the listener of each observed pin whose level is not what it was.
static void port_changed(board *b, int index, uint8_t direction, uint8_t latch) {
  uint8_t before = b->ports[index].direction & b->ports[index].latch;
  uint8_t after = direction & latch;
  b->ports[index].direction = direction;
  b->ports[index].latch = latch;
  uint8_t changed = (before ^ after) & b->ports[index].observed;
  for (int bit = 0; changed >> bit; bit++)
    if (changed >> bit & 1)
      b->listener.output(b->listener.context, pin_at(b->model, (char)('A' + index), bit), after >> bit & 1,
                         board_now(b));
}

static void latch_written(struct avr_irq_t *irq, uint32_t value, void *context) {
  struct board_port_link *link = context;
  (void)irq;
  port_changed(link->owner, link->index, link->owner->ports[link->index].direction, (uint8_t)value);
}

static void direction_written(struct avr_irq_t *irq, uint32_t value, void *context) {
  struct board_port_link *link = context;
  (void)irq;
  port_changed(link->owner, link->index, (uint8_t)value, link->owner->ports[link->index].latch);
}

static void link_ports(board *b) {
  for (int i = 0; i < BOARD_PORTS; i++) {
    struct board_port_link *link = malloc(sizeof *link);
    if (!link) abort();  // out of memory: nothing sensible is left to do
    *link = (struct board_port_link){b, i};
    b->ports[i].link = link;
    avr_irq_register_notify(port_irq(b, i, IOPORT_IRQ_REG_PORT), latch_written, link);
    avr_irq_register_notify(port_irq(b, i, IOPORT_IRQ_DIRECTION_ALL), direction_written, link);
  }
}

// Called by simavr in the middle of a reset: too early to touch any pin.
static void chip_reset(struct avr_t *avr) {
  board *b = avr->custom.data;
  b->reset_pending = true;
}

// The interrupt of a watchdog that is to reset the chip disables itself; simavr has each do so.
static void serve_interrupts(struct avr_t *avr) {
  bool stays = (avr->data[WDTCSR] & (WDIE | WDE)) == WDIE;
  avr_service_interrupts(avr);
  if (stays) avr->data[WDTCSR] |= WDIE;
}

static void run_once(struct avr_t *avr) {
  board *b = avr->custom.data;
  avr_flashaddr_t pc = avr->pc;
  if (b->halted) avr->state = cpu_Sleeping;  // simavr has let an interrupt wake it, which the chip does not
  bool starting = avr->state == cpu_Running && !sleep_is_over(&b->sleep);
  if (avr->state == cpu_Running && !starting) {
    cycles_t left = b->limit - avr->cycle;
    avr->run_cycle_limit = left < RUN_LIMIT ? left : RUN_LIMIT;
    pc = avr_run_one(avr);
    if (avr->state == cpu_Sleeping) sleep_begin(&b->sleep);
  }
  cycles_t next = avr_cycle_timer_process(avr);
  avr->pc = pc;
  if ((avr->state == cpu_Sleeping || starting) && avr->cycle < b->limit) {
    cycles_t end = starting && b->sleep.started_at < b->limit ? b->sleep.started_at : b->limit;
    cycles_t left = end - avr->cycle;
    b->halted = avr->state == cpu_Sleeping && !avr->sreg[S_I];
    avr->cycle += next < left ? (next ? next : 1) : left;
  }
  if (avr->interrupt_state && (avr->state == cpu_Running || avr->state == cpu_Sleeping)) serve_interrupts(avr);
}

static void eeprom_written(void *context, uint16_t address, uint8_t byte) {
  board *b = context;
  b->listener.eeprom_written(b->listener.context, address, byte);
}

static void point_written(struct avr_t *avr, avr_io_addr_t address, uint8_t value, void *context) {
  board *b = context;
  avr->data[address] = value;
  b->listener.point(b->listener.context, value, avr->data[GPIOR1], avr->data[GPIOR2]);
}

// Fills a gap of simavr: it knows no phase-correct PWM, and a timer in such a mode overflows at each of its clocks; the
// Arduino core puts timers 1 to 5 into that mode at start. Takes it as fast PWM of the same width, which overflows twice as
// often as the chip would. An idle Arduino then takes a fifteenth of the work.
static void complete_timer_modes(struct avr_t *avr) {
  for (avr_io_t *part = avr->io_port; part; part = part->next) {
    if (!part->kind || strcmp(part->kind, "timer") != 0) continue;
    avr_timer_t *timer = (avr_timer_t *)part;  // each part begins with its avr_io_t
    for (int mode = FIRST_MODE; mode <= LAST_MODE; mode++)
      if (timer->wgm_op[mode].kind == avr_timer_wgm_none)
        timer->wgm_op[mode] = (avr_timer_wgm_t){.kind = avr_timer_wgm_fast_pwm,
                                                .size = (uint32_t)(FIRST_WIDTH + mode - FIRST_MODE) & 0xF};
  }
}

static void duty_changed(void *context, char port, int bit, double duty) {
  board *b = context;
  if (b->ports[port_index(port)].observed >> bit & 1)
    b->listener.duty(b->listener.context, pin_at(b->model, port, bit), duty, board_now(b));
}

int board_init(board *b, const model *m, const char *firmware, board_listener listener, char *error,
               size_t error_size) {
  memset(b, 0, sizeof *b);
  b->model = m;
  b->listener = listener;
  b->avr = avr_make_mcu_by_name(m->mcu);
  avr_init(b->avr);
  b->avr->custom.data = b;
  b->avr->run = run_once;
  b->avr->frequency = CYCLES_PER_SECOND / m->clock_cycles;
  b->avr->vcc = b->avr->avcc = b->avr->aref = (uint32_t)m->supply_mv;
  b->avr->reset = chip_reset;
  complete_timer_modes(b->avr);
  link_ports(b);
  pwm_init(&b->duties, b->avr, (pwm_listener){b, duty_changed});
  avr_register_io_write(b->avr, GPIOR0, point_written, b);
  eeprom_init(&b->memory, b->avr, (eeprom_listener){b, eeprom_written});
  sleep_init(&b->sleep, b->avr, m);
  return firmware_load(b->avr, m, firmware, error, error_size);
}

void board_release(board *b) {
  if (!b->avr) return;
  pwm_release(&b->duties);
  avr_terminate(b->avr);
  free(b->avr);
  for (int i = 0; i < BOARD_PORTS; i++) free(b->ports[i].link);
  free(b->inputs);
}

void board_observe(board *b, int pin) {
  pin_location location = pin_locate(b->model, pin);
  b->ports[port_index(location.port)].observed |= (uint8_t)(1 << location.bit);
}

bool board_output(const board *b, int pin) {
  pin_location location = pin_locate(b->model, pin);
  int index = port_index(location.port);
  return b->ports[index].direction & b->ports[index].latch & 1 << location.bit;
}

static void raise_inputs(board *b, int index) {
  for (int bit = 0; bit < 8; bit++) {
    struct avr_irq_t *irq = port_irq(b, index, bit);
    if (!irq) return;  // no such port
    // simavr passes on only changes, and the reset has cleared what it had passed on: of the program's pull-ups quietly,
    // as nothing has happened at the pin.
    if (b->ports[index].driven >> bit & 1) {
      avr_raise_irq(irq, 0);
      avr_raise_irq(irq, b->ports[index].external >> bit & 1);
    } else {
      irq->value = 0;
    }
  }
}

// Tells that all pins are inputs now, which simavr does not.
static void release_outputs(board *b) {
  for (int i = 0; i < BOARD_PORTS; i++) {
    struct avr_irq_t *latch = port_irq(b, i, IOPORT_IRQ_REG_PORT);
    if (!latch) continue;  // no chip has a port I, and a small one few others
    avr_raise_irq(latch, 0);
    avr_raise_irq(port_irq(b, i, IOPORT_IRQ_DIRECTION_ALL), 0);
  }
  pwm_reset(&b->duties);
}

static void settle_after_reset(board *b) {
  b->reset_pending = false;
  b->halted = false;
  sleep_reset(&b->sleep);
  eeprom_reset(&b->memory);
  release_outputs(b);
  for (int i = 0; i < BOARD_PORTS; i++) raise_inputs(b, i);
  b->listener.reset(b->listener.context, b->cause);
  b->cause = RESET_WATCHDOG;  // what it must have been if nobody asks for it
}

static void restart(board *b, reset_cause cause) {
  b->cause = cause;
  avr_reset(b->avr);
  avr_regbit_set(b->avr, cause == RESET_POWER ? b->avr->reset_flags.porf : b->avr->reset_flags.extrf);
  settle_after_reset(b);
}

static void fill(uint8_t *bytes, size_t count, prng *noise) {
  for (size_t i = 0; i < count; i++) bytes[i] = (uint8_t)prng_next(noise);
}

void board_power_on(board *b, prng *noise) {
  size_t ram = b->avr->ioend + 1u;
  fill(b->avr->data, REGISTERS, noise);
  fill(b->avr->data + ram, b->avr->ramend + 1u - ram, noise);
  b->powered = true;
  restart(b, RESET_POWER);
}

int board_power_off(board *b, prng *noise) {
  b->powered = b->stopped = b->reset_pending = false;
  b->avr->state = cpu_Stopped;
  release_outputs(b);
  return eeprom_tear(&b->memory, noise);
}

void board_reset(board *b) {
  if (b->powered) restart(b, RESET_EXTERNAL);
}

void board_stop(board *b) {
  b->stopped = true;
  // simavr runs several instructions in one call; this ends it after the one under way.
  b->avr->run_cycle_count = 0;
}

void board_drive(board *b, int pin, bool level) {
  pin_location location = pin_locate(b->model, pin);
  int index = port_index(location.port);
  uint8_t mask = (uint8_t)(1 << location.bit);
  b->ports[index].driven |= mask;
  b->ports[index].external = (uint8_t)(level ? b->ports[index].external | mask : b->ports[index].external & ~mask);
  // The pull-ups of simavr would otherwise win over what drives the pin.
  avr_ioport_external_t pull = {
      .name = (unsigned char)location.port & 0x7F, .mask = b->ports[index].driven, .value = b->ports[index].external};
  avr_ioctl(b->avr, (uint32_t)AVR_IOCTL_IOPORT_SET_EXTERNAL(location.port), &pull);
  avr_raise_irq(port_irq(b, index, location.bit), level);
}

void board_drive_at(board *b, int pin, bool level, cycles_t at) {
  if (b->input_count == b->input_capacity) {
    size_t capacity = b->input_capacity ? 2 * b->input_capacity : 32;
    board_input *inputs = realloc(b->inputs, capacity * sizeof *inputs);
    if (!inputs) abort();  // out of memory: nothing sensible is left to do
    b->inputs = inputs;
    b->input_capacity = capacity;
  }
  size_t place = b->input_count++;
  for (; place > 0 && b->inputs[place - 1].at <= at; place--) b->inputs[place] = b->inputs[place - 1];
  b->inputs[place] = (board_input){at, pin, level};
}

static cycles_t next_input(const board *b) { return b->input_count ? b->inputs[b->input_count - 1].at : NEVER; }

static void take_inputs(board *b) {
  while (next_input(b) <= board_now(b)) {
    board_input input = b->inputs[--b->input_count];
    board_drive(b, input.pin, input.level);
  }
}

// Runs the chip to the limit, a reset or a stop. Returns 0, or -1 when the program has crashed.
static int run_chip(board *b) {
  while (b->avr->cycle < b->limit && !b->reset_pending && !b->stopped) {
    b->avr->run(b->avr);
    if (b->avr->state == cpu_Crashed) return -1;
  }
  if (b->reset_pending) settle_after_reset(b);
  return 0;
}

int board_run(board *b, cycles_t until) {
  b->stopped = false;
  while (board_now(b) < until && !b->stopped) {
    take_inputs(b);
    cycles_t next = next_input(b);
    b->limit = on_chip(b, next < until ? next : until);
    if (!b->powered)
      b->avr->cycle = b->limit;
    else if (run_chip(b) != 0)
      return -1;
  }
  return 0;
}

bool board_hears_bytes(const board *b) { return !b->sleep.stopped; }

cycles_t board_now(const board *b) { return on_clock(b, b->avr->cycle); }

cycles_t board_next_event(const board *b) {
  cycles_t next = next_input(b);
  if (!b->powered) return next;
  if (b->avr->state == cpu_Sleeping && !b->halted && b->avr->cycle_timers.timer) {
    cycles_t timer = on_clock(b, b->avr->cycle_timers.timer->when);
    return timer < next ? timer : next;
  }
  return b->avr->state == cpu_Sleeping ? next : board_now(b);
}

uint32_t board_pc(const board *b) { return b->avr->pc; }
