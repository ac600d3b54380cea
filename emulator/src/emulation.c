// SPDX-License-Identifier: GPL-3.0-or-later
#include "emulation.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "firmware.h"
#include "scenario_event.h"
#include "scenario_fault.h"
#include "utf8.h"

// Stream numbers of the seed from here on are those of the boards' power.
#define POWER_STREAM 2000
#define CM_PER_M 100

static bool is_motor(const vehicle_config *vehicle, int pin) {
  bool found = false;
  for (int side = MOTOR_LEFT; side <= MOTOR_RIGHT; side++)
    found |= pin == vehicle->forward[side] || pin == vehicle->backward[side];
  return vehicle->radius_m > 0 && found;
}

// Tells of a watched pin its level, or if it has a duty, that.
static void tell_pin(node *n, int pin, bool level, double duty, cycles_t at) {
  trace *out = n->owner->out;
  for (size_t i = 0; i < n->config->watch_count; i++) {
    if (n->config->watches[i].pin != pin) continue;
    trace_begin(out, at, n->config->name, duty < 0 ? "pin" : "pwm");
    trace_count(out, "pin", (uint64_t)pin);
    trace_text(out, "name", n->config->watches[i].name);
    if (duty < 0)
      trace_count(out, "level", level);
    else
      trace_number(out, "duty", duty);
    trace_end(out);
  }
}

static void duty_changed(void *context, int pin, double duty, cycles_t at) {
  node *n = context;
  tell_pin(n, pin, board_output(&n->arduino, pin), duty, at);
}

static void pin_changed(void *context, int pin, bool level, cycles_t at) {
  node *n = context;
  emulation *e = n->owner;
  if (pin == n->config->tx_pin && !e->modules.modules) {
    rf_bus_carrier(&e->air, n->index, level, at);
    sniffer_tx_edge(&e->listener, n->index, level, at);
  }
  fault_plan_output(&e->faults, n->index, pin, level, at);
  if (is_motor(&n->config->vehicle, pin)) world_wake(&e->surroundings, at);
  for (size_t i = 0; i < n->config->sensor_count; i++) sensor_output(&n->sensors[i], pin, level, at);
  tell_pin(n, pin, level, -1, at);
}

static void board_was_reset(void *context, reset_cause cause) {
  static const char *const CAUSES[] = {"power", "external", "watchdog"};
  node *n = context;
  uart_reset(&n->serial);
  serial_sniffer_reset(&n->line);
  point_log_reset(&n->declared);
  n->resets += cause != RESET_POWER;
  trace_begin(n->owner->out, board_now(&n->arduino), n->config->name, "reset");
  trace_text(n->owner->out, "why", n->reset_why ? n->reset_why : CAUSES[cause]);
  trace_end(n->owner->out);
  n->reset_why = NULL;
}

static void point_told(void *context, uint8_t number, uint8_t first, uint8_t second) {
  node *n = context;
  point_log_tell(&n->declared, number, first, second, board_now(&n->arduino));
}

static void eeprom_written(void *context, uint16_t address, uint8_t byte) {
  node *n = context;
  point_log_eeprom(&n->declared, address, byte, board_now(&n->arduino));
  n->cut = fault_plan_write(&n->owner->faults, n->index, board_now(&n->arduino));
  if (n->cut) board_stop(&n->arduino);
}

static void reset_node(node *n, const char *why) {
  if (!n->arduino.powered) return;
  n->reset_why = why;
  board_reset(&n->arduino);
}

static void uart_line(void *context, const uint8_t *bytes, size_t length) {
  node *n = context;
  trace *out = n->owner->out;
  trace_begin(out, board_now(&n->arduino), n->config->name, "uart");
  if (utf8_valid(bytes, length))
    trace_utf8(out, "line", bytes, length);
  else
    trace_hex(out, "hex", bytes, length);
  trace_end(out);
}

static void uart_byte(void *context, bool from_host, uint8_t byte) {
  node *n = context;
  serial_sniffer_byte(&n->line, from_host, byte, board_now(&n->arduino));
}

static void level_arrives(void *context, size_t receiver, bool level, cycles_t at) {
  emulation *e = context;
  node *n = &e->nodes[receiver];
  if (e->modules.modules) return;
  board_drive_at(&n->arduino, n->config->rx_pin, level, at);
  sniffer_rx_edge(&e->listener, receiver, level, at);
}

static void carriers_overlap(void *context, size_t receiver, uint64_t sources, cycles_t at) {
  emulation *e = context;
  serial_modules_collision(&e->modules, receiver, sources);
  sniffer_collision(&e->listener, receiver, sources, at);
}

static int motor_turns(void *context, size_t board, world_motor motor) {
  const emulation *e = context;
  const vehicle_config *vehicle = &e->config->boards[board].vehicle;
  return board_output(&e->nodes[board].arduino, vehicle->forward[motor]) -
         board_output(&e->nodes[board].arduino, vehicle->backward[motor]);
}

static void board_placed(void *context, size_t board, bool told, cycles_t at) {
  emulation *e = context;
  const world_body *body = &e->surroundings.bodies[board];
  rf_bus_move(&e->air, board, body->x_m, body->y_m, at);
  if (!told) return;
  trace_begin(e->out, at, e->config->boards[board].name, "place");
  trace_numbers(e->out, "position", (const double[]){body->x_m, body->y_m}, 2);
  trace_number(e->out, "heading", body->heading_deg);
  trace_end(e->out);
}

static double world_value(void *context, sensor_kind kind) {
  const node *n = context;
  const world *around = &n->owner->surroundings;
  return kind == SENSOR_HC_SR04 ? CM_PER_M * world_distance_m(around, n->index) : around->light;
}

static void injector_begins(void *context, const injector_packet *packet, cycles_t at) {
  emulation *e = context;
  rf_bus_move(&e->air, e->config->board_count, packet->x_m, packet->y_m, at);
}

static void injector_carrier(void *context, bool carrier, cycles_t at) {
  emulation *e = context;
  rf_bus_carrier(&e->air, e->config->board_count, carrier, at);
  sniffer_tx_edge(&e->listener, e->config->board_count, carrier, at);
}

static int plug(emulation *e, node *n) { return pty_plug(&n->port, n->config->port, e->error, sizeof e->error); }

static void observe_pins(node *n) {
  const scenario *scenario = n->owner->config;
  board_observe(&n->arduino, n->config->tx_pin);
  for (size_t i = 0; i < n->config->watch_count; i++) board_observe(&n->arduino, n->config->watches[i].pin);
  for (size_t i = 0; i < scenario->fault_count; i++)
    if (scenario->faults[i].after_pin >= 0 && scenario->faults[i].board == n->index)
      board_observe(&n->arduino, scenario->faults[i].after_pin);
  for (int side = MOTOR_LEFT; side <= MOTOR_RIGHT && n->config->vehicle.radius_m > 0; side++) {
    board_observe(&n->arduino, n->config->vehicle.forward[side]);
    board_observe(&n->arduino, n->config->vehicle.backward[side]);
  }
  board_drive(&n->arduino, n->config->rx_pin, false);
}

static int out_of_memory(emulation *e) {
  snprintf(e->error, sizeof e->error, "out of memory");
  return -1;
}

static int open_node(emulation *e, node *n, uint8_t *const *eeproms) {
  char error[400];
  if (board_init(&n->arduino, n->config->model, n->config->firmware,
                 (board_listener){n, pin_changed, board_was_reset, eeprom_written, point_told, duty_changed}, error,
                 sizeof error) != 0 ||
      (n->config->boot_loader &&
       firmware_add_boot_loader(n->arduino.avr, n->config->model, n->config->boot_loader, error, sizeof error) != 0)) {
    snprintf(e->error, sizeof e->error, "board %s: %s", n->config->name, error);
    return -1;
  }
  n->arduino.clock_error_ppm = n->config->clock_error_ppm;
  serial_sniffer_init(&n->line, e->out, n->config->name);
  point_log_init(&n->declared, e->out, n->config->name, &e->listener.stations[n->index].heard,
                 n->config->model->clock_cycles);
  uart_init(&n->serial, &n->arduino, n->config->port ? &n->port : NULL, (uart_listener){n, uart_line, uart_byte});
  serial_modules_join(&e->modules, n->index, &n->arduino);
  n->sensors = calloc(n->config->sensor_count + 1, sizeof *n->sensors);
  if (!n->sensors) return out_of_memory(e);
  for (size_t i = 0; i < n->config->sensor_count; i++)
    sensor_init(&n->sensors[i], &n->arduino, &n->config->sensors[i], (sensor_world){n, world_value, &n->noise});
  observe_pins(n);
  if (eeproms && eeproms[n->index]) eeprom_load(&n->arduino.memory, eeproms[n->index]);
  if (n->config->eeprom && !eeproms &&
      eeprom_file_open(&n->eeprom, n->arduino.avr, n->config->model->eeprom_size, n->config->eeprom, e->error,
                       sizeof e->error) != 0)
    return -1;
  if (n->config->port && plug(e, n) != 0) return -1;
  board_power_on(&n->arduino, &n->noise);
  return 0;
}

static int open_all(emulation *e, const scenario *config, uint64_t seed, trace *out, bool played,
                    uint8_t *const *eeproms) {
  memset(e, 0, sizeof *e);
  e->config = config;
  e->out = out;
  e->next_eeprom_save = EEPROM_INTERVAL;
  e->speed_asked = -1;
  e->nodes = calloc(config->board_count, sizeof *e->nodes);
  if (!e->nodes) return out_of_memory(e);
  if (fault_plan_init(&e->faults, config) != 0 ||
      world_init(&e->surroundings, config, (world_listener){e, motor_turns, board_placed}) != 0)
    return out_of_memory(e);
  injector_init(&e->injector, config->radio.bit_rate, (injector_listener){e, injector_begins, injector_carrier});
  if (rf_bus_init(&e->air, config, seed, (rf_listener){e, level_arrives, carriers_overlap}) != 0 ||
      sniffer_init(&e->listener, config, &e->air, out) != 0) {
    snprintf(e->error, sizeof e->error, "boards and jams at one time must not be more than 63 together");
    return -1;
  }
  if (serial_modules_init(&e->modules, config, seed, &e->air, &e->listener) != 0) return out_of_memory(e);
  for (; e->node_count < config->board_count; e->node_count++) {
    node *n = &e->nodes[e->node_count];
    n->owner = e;
    n->index = e->node_count;
    n->config = &config->boards[n->index];
    n->port.master = -1;
    n->port.played = played;
    n->port.usb.latency = seconds_to_cycles(n->config->bridge_latency_ms / 1000);
    n->plugged = n->config->port != NULL;
    n->power_at = NEVER;
    prng_seed(&n->noise, seed, POWER_STREAM + n->index);
  }
  scenario_event_write(out, config, seed);
  for (size_t i = 0; i < e->node_count; i++)
    if (open_node(e, &e->nodes[i], eeproms) != 0) return -1;
  return 0;
}

int emulation_open(emulation *e, const scenario *config, uint64_t seed, trace *out) {
  return open_all(e, config, seed, out, false, NULL);
}

void emulation_keep(emulation *e, record *kept, FILE *keys) {
  e->kept = kept;
  for (size_t i = 0; i < e->node_count; i++) e->nodes[i].line.keys = keys;
}

int emulation_open_played(emulation *e, const scenario *config, uint64_t seed, trace *out, uint8_t *const *eeproms) {
  return open_all(e, config, seed, out, true, eeproms);
}

static void trace_port(const node *n, const char *state) {
  trace_begin(n->owner->out, n->owner->now, n->config->name, "port");
  trace_text(n->owner->out, "state", state);
  trace_end(n->owner->out);
}

static void trace_fault(const emulation *e, const fault_config *fault) {
  trace_begin(e->out, e->now, fault->kind == FAULT_JAM ? NULL : e->nodes[fault->board].config->name, "fault");
  trace_text(e->out, "do", fault_name(fault->kind));
  if (fault->kind == FAULT_JAM && fault->has_position)
    trace_numbers(e->out, "position", (const double[]){fault->x_m, fault->y_m}, 2);
  if (fault->kind == FAULT_JAM) trace_time(e->out, "until", e->now + seconds_to_cycles(fault->duration_s));
  trace_end(e->out);
}

static void trace_cut(const node *n, cycles_t at, int torn) {
  trace *out = n->owner->out;
  trace_begin(out, at, n->config->name, "fault");
  trace_text(out, "do", fault_name(FAULT_POWER_CUT));
  trace_time(out, "until", n->power_at);
  if (torn >= 0) trace_count(out, "torn", (uint64_t)torn);
  trace_end(out);
}

static void unplug(node *n) {
  if (n->port.master < 0) return;
  pty_unplug(&n->port);
  trace_port(n, "unplugged");
}

static int plug_again(emulation *e, node *n) {
  if (!n->plugged || n->port.master >= 0) return 0;
  trace_port(n, "plugged");
  return plug(e, n);
}

// A cut during another one makes it longer, not shorter.
static void cut_power(node *n, const fault_config *fault) {
  cycles_t now = board_now(&n->arduino);
  cycles_t back = now + seconds_to_cycles(fault->duration_s);
  n->power_at = n->power_at == NEVER || back > n->power_at ? back : n->power_at;
  n->power_cuts++;
  trace_cut(n, now, board_power_off(&n->arduino, &n->noise));
  uart_reset(&n->serial);
  serial_modules_power_off(&n->owner->modules, n->index);
  unplug(n);
}

static int restore_power(emulation *e, node *n) {
  if (e->now < n->power_at) return 0;
  n->power_at = NEVER;
  board_power_on(&n->arduino, &n->noise);
  return plug_again(e, n);
}

int emulation_fault(emulation *e, const fault_config *fault) {
  node *n = &e->nodes[fault->board];
  if (fault->kind != FAULT_POWER_CUT) trace_fault(e, fault);
  switch (fault->kind) {
    case FAULT_RESET: reset_node(n, "fault"); break;
    case FAULT_UNPLUG:
      n->plugged = false;
      unplug(n);
      break;
    case FAULT_PLUG: n->plugged = true; return n->arduino.powered ? plug_again(e, n) : 0;
    case FAULT_POWER_CUT: cut_power(n, fault); break;
    case FAULT_JAM: break;
  }
  return 0;
}

static int perform_faults(emulation *e) {
  const fault_config *fault;
  while ((fault = fault_plan_take(&e->faults, e->now)) != NULL) {
    if (fault->kind == FAULT_JAM)
      rf_bus_jam(&e->air, e->next_jam++, e->now, e->now + seconds_to_cycles(fault->duration_s));
    if (emulation_fault(e, fault) != 0) return -1;
  }
  for (size_t i = 0; i < e->node_count; i++)
    if (restore_power(e, &e->nodes[i]) != 0) return -1;
  return 0;
}

static int save_eeproms(emulation *e) {
  for (size_t i = 0; i < e->node_count; i++)
    if (e->nodes[i].eeprom.live && eeprom_file_save(&e->nodes[i].eeprom, e->error, sizeof e->error) != 0) return -1;
  return 0;
}

// Faults and EEPROM files come when their time is reached, at the border of two steps.
static int do_due(emulation *e) {
  if (perform_faults(e) != 0) return -1;
  world_advance(&e->surroundings, e->now);
  if (e->now < e->next_eeprom_save) return 0;
  e->next_eeprom_save = e->now + EEPROM_INTERVAL;
  return save_eeproms(e);
}

static cycles_t earliest(cycles_t a, cycles_t b) { return a < b ? a : b; }

static cycles_t node_next_event(const node *n) {
  cycles_t next = earliest(board_next_event(&n->arduino), n->power_at);
  for (size_t i = 0; i < n->config->sensor_count; i++) next = earliest(next, sensor_next_event(&n->sensors[i]));
  return next;
}

cycles_t emulation_next_event(const emulation *e) {
  cycles_t end =
      earliest(earliest(e->air.next_event, e->faults.next), earliest(e->surroundings.next_step, e->injector.next));
  end = earliest(end, serial_modules_next(&e->modules));
  for (size_t i = 0; i < e->node_count && end > e->now + RF_STEP; i++)
    end = earliest(end, node_next_event(&e->nodes[i]));
  return end;
}

// One step; a longer one while all boards sleep, up to where the first thing happens.
static cycles_t step_end(const emulation *e, cycles_t until) {
  cycles_t end = emulation_next_event(e);
  end = end < e->now + RF_STEP ? e->now + RF_STEP : end;
  return earliest(end, until);
}

static int run_board(emulation *e, node *n, cycles_t end) {
  for (size_t i = 0; i < n->config->sensor_count; i++) sensor_advance(&n->sensors[i], end);
  while (board_run(&n->arduino, end) == 0) {
    if (!n->cut) return 0;
    cut_power(n, n->cut);
    n->cut = NULL;
  }
  trace_begin(e->out, board_now(&n->arduino), n->config->name, "crash");
  trace_end(e->out);
  snprintf(e->error, sizeof e->error, "board %s: its program crashed at pc 0x%05x, after %.6f s", n->config->name,
           board_pc(&n->arduino), cycles_to_seconds(board_now(&n->arduino)));
  return -1;
}

int emulation_run(emulation *e, cycles_t until) {
  while (e->now < until) {
    if (do_due(e) != 0) return -1;
    cycles_t end = step_end(e, until);
    for (size_t i = 0; i < e->node_count; i++)
      if (run_board(e, &e->nodes[i], end) != 0) return -1;
    injector_advance(&e->injector, end);
    // A packet must be known at its sender before it arrives anywhere: hence this order.
    sniffer_advance_tx(&e->listener, end);
    serial_modules_send(&e->modules, e->now, end);
    rf_bus_advance(&e->air, end);
    serial_modules_receive(&e->modules, end);
    sniffer_advance_rx(&e->listener, end);
    e->now = end;
  }
  return 0;
}

void emulation_exchange(emulation *e) {
  for (size_t i = 0; i < e->node_count; i++) {
    node *n = &e->nodes[i];
    pty_change change = pty_exchange(&n->port, e->now);
    if (e->kept) record_port(e->kept, n->config->name, &n->port, change);
    if (change != PTY_SAME) trace_port(n, change == PTY_OPENED ? "open" : "closed");
    if (change == PTY_OPENED && n->config->reset_on_open) reset_node(n, "port opened");
    uart_pump(&n->serial);
  }
  if (e->kept) record_exchange_end(e->kept);
}

void emulation_hold(emulation *e, bool held) {
  for (size_t i = 0; i < e->node_count; i++) pty_hold(&e->nodes[i].port, held);
}

size_t emulation_descriptors(const emulation *e, struct pollfd *descriptors) {
  size_t count = 0;
  for (size_t i = 0; i < e->node_count; i++) {
    int descriptor = pty_poll_descriptor(&e->nodes[i].port);
    if (descriptor >= 0) descriptors[count++] = (struct pollfd){descriptor, POLLIN, 0};
  }
  return count;
}

bool emulation_serial_busy(const emulation *e) {
  for (size_t i = 0; i < e->node_count; i++)
    if (e->nodes[i].port.open && e->now - e->nodes[i].serial.last_byte < 2 * CYCLES_PER_MS) return true;
  return false;
}

static void trace_counters(const emulation *e, const node *n) {
  const sniffer_station *station = &e->listener.stations[n->index];
  const sniffer_counters *radio = &station->counters;
  trace_begin(e->out, e->now, n->config->name, "counters");
  trace_count(e->out, "resets", n->resets);
  trace_count(e->out, "powerCuts", n->power_cuts);
  trace_count(e->out, "faultsPending", fault_plan_pending(&e->faults, n->index));
  trace_count(e->out, "eepromWrites", n->arduino.memory.writes);
  trace_count(e->out, "serialReceived", n->port.received);
  trace_count(e->out, "serialSent", n->port.sent);
  trace_count(e->out, "serialDropped", n->port.dropped);
  trace_count(e->out, "radioSent", radio->sent);
  trace_count(e->out, "radioUndecodable", radio->undecodable);
  trace_count(e->out, "radioReceived", radio->received);
  trace_count(e->out, "radioDamaged", radio->damaged);
  trace_count(e->out, "radioCollisions", radio->collisions);
  trace_count(e->out, "radioNotFollowed", radio->not_followed);
  if (station->hours > 0) trace_numbers(e->out, "airtime", station->airtime_s, station->hours);
  trace_end(e->out);
}

static void close_node(emulation *e, node *n) {
  if (n->arduino.avr && n->serial.input) {
    uart_flush(&n->serial);
    point_log_flush(&n->declared, e->now);
    trace_counters(e, n);
  }
  pty_unplug(&n->port);
  board_release(&n->arduino);
  free(n->sensors);
  eeprom_file_close(&n->eeprom);
}

int emulation_close(emulation *e) {
  int result = save_eeproms(e);
  sniffer_end(&e->listener);
  for (size_t i = 0; i < e->node_count; i++) close_node(e, &e->nodes[i]);
  serial_modules_release(&e->modules);
  sniffer_release(&e->listener);
  rf_bus_release(&e->air);
  fault_plan_release(&e->faults);
  world_release(&e->surroundings);
  free(e->nodes);
  return result;
}
