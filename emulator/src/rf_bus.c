// SPDX-License-Identifier: GPL-3.0-or-later
#include "rf_bus.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "propagation.h"

// Stream numbers of the seed: receivers' errors from 0, and from these on the others.
#define JAM_STREAM 1000
#define BURST_STREAM 3000
#define NOISE_STREAM 3500
// Whatever is closer than that is heard as from there.
#define NEAREST_M 1

static uint64_t bit_of(size_t source) { return (uint64_t)1 << source; }

static double metres_between(const rf_bus *bus, size_t receiver, size_t index) {
  const rf_source *own = &bus->sources[receiver], *source = &bus->sources[index];
  if (source->everywhere) return 0;
  return propagation_metres(&bus->radio, bus->seed, receiver, index,
                            hypot(own->x_m - source->x_m, own->y_m - source->y_m));
}

// Says anew whether a receiver hears a source; a level that changes by it changes at `now`.
static void find_hearing(rf_bus *bus, size_t receiver, size_t index, cycles_t now) {
  uint64_t *hears = &bus->receivers[receiver].hears;
  double *metres = &bus->receivers[receiver].metres[index];
  *metres = metres_between(bus, receiver, index);
  bool heard = index != receiver && *metres <= bus->radio.range_m;
  if (heard == ((*hears & bit_of(index)) != 0)) return;
  *hears ^= bit_of(index);
  if (now < bus->next_event) bus->next_event = now;
}

static void find_hearers(rf_bus *bus, size_t index, cycles_t now) {
  for (size_t r = 0; r < bus->board_count; r++) find_hearing(bus, r, index, now);
}

static void find_all_hearers(rf_bus *bus, cycles_t now) {
  for (size_t i = 0; i < bus->source_count; i++) find_hearers(bus, i, now);
}

// Gives each jam the first jammer that is silent by then. Returns 0, or -1 when there are too many.
static int init_jams(rf_bus *bus, const scenario *config) {
  cycles_t silent_at[MAX_SOURCES];
  const cycles_t pause = RF_QUIET_BITS * bus->bit_cycles + 2 * RF_STEP;
  size_t jams = 0;
  for (size_t i = 0; i < config->fault_count; i++) {
    const fault_config *fault = &config->faults[i];
    if (fault->kind != FAULT_JAM) continue;
    cycles_t begin = seconds_to_cycles(fault->t_s);
    size_t source = bus->board_count + 1;
    while (source < bus->source_count && silent_at[source] > begin) source++;
    if (source == MAX_SOURCES) return -1;
    bus->source_count += source == bus->source_count;
    silent_at[source] = begin + seconds_to_cycles(fault->duration_s) + pause;
    bus->jams[jams++] = (rf_jam){source, fault};
  }
  return 0;
}

static void init_source(rf_bus *bus, size_t index) {
  rf_source *source = &bus->sources[index];
  source->quiet_at = NEVER;
  source->next_toggle = NEVER;
  if (index > bus->board_count) prng_seed(&source->noise, bus->seed, JAM_STREAM + index - bus->board_count - 1);
}

static void init_receiver(rf_bus *bus, size_t index) {
  rf_receiver *receiver = &bus->receivers[index];
  prng_seed(&receiver->errors, bus->seed, index);
  prng_seed(&receiver->bursts, bus->seed, BURST_STREAM + index);
  prng_seed(&receiver->noise, bus->seed, NOISE_STREAM + index);
}

// The share of time that bursts take: they alone have errors.
static double burst_share(const rf_bus *bus) { return bus->radio.bursts.rate / bus->radio.bursts.rate_within; }

static cycles_t burst_length(rf_bus *bus, rf_receiver *receiver) {
  double bits = bus->radio.bursts.length_bits;
  if (!receiver->in_burst) bits *= 1 / burst_share(bus) - 1;
  return (cycles_t)prng_exponential(&receiver->bursts, bits * (double)bus->bit_cycles) + 1;
}

static void start_bursts(rf_bus *bus, rf_receiver *receiver, cycles_t now) {
  if (bus->radio.bursts.rate <= 0) return;
  receiver->in_burst = prng_chance(&receiver->bursts, burst_share(bus));
  receiver->burst_change = now + burst_length(bus, receiver);
}

static cycles_t noise_start(const rf_bus *bus, cycles_t now) {
  return bus->radio.noise.edges_per_s > 0 ? now + seconds_to_cycles(bus->radio.noise.after_s) : NEVER;
}

static void take_radio(rf_bus *bus, const radio_config *radio, cycles_t now) {
  bus->radio = *radio;
  bus->has_errors = radio->bit_error_rate > 0 || radio->bursts.rate > 0 || radio->distance_rate_count > 0;
  bus->capture_ratio = radio->capture_db > 0 ? propagation_capture_ratio(radio) : 0;
  for (size_t r = 0; r < bus->board_count; r++) {
    rf_receiver *receiver = &bus->receivers[r];
    receiver->hearing = receiver->flip = false;
    receiver->next_slot = noise_start(bus, now);
    start_bursts(bus, receiver, now);
  }
}

int rf_bus_init(rf_bus *bus, const scenario *config, uint64_t seed, rf_listener listener) {
  memset(bus, 0, sizeof *bus);
  bus->listener = listener;
  bus->bit_cycles = (cycles_t)(CYCLES_PER_SECOND / config->radio.bit_rate + 0.5);
  bus->seed = seed;
  bus->board_count = config->board_count;
  bus->source_count = config->board_count + 1;
  bus->next_event = 0;  // finds what really comes first
  bus->jams = calloc(config->fault_count + 1, sizeof *bus->jams);
  if (!bus->jams || init_jams(bus, config) != 0) return -1;
  bus->planned_count = bus->source_count;
  bus->sources = calloc(MAX_SOURCES, sizeof *bus->sources);
  bus->receivers = calloc(bus->board_count, sizeof *bus->receivers);
  if (!bus->sources || !bus->receivers) return -1;
  for (size_t i = 0; i < bus->source_count; i++) init_source(bus, i);
  for (size_t i = 0; i < bus->board_count; i++) {
    bus->sources[i].x_m = config->boards[i].x_m;
    bus->sources[i].y_m = config->boards[i].y_m;
    init_receiver(bus, i);
  }
  take_radio(bus, &config->radio, 0);
  find_all_hearers(bus, NEVER);
  return 0;
}

void rf_bus_release(rf_bus *bus) {
  free(bus->sources);
  free(bus->receivers);
  free(bus->jams);
  free(bus->edges);
}

bool rf_bus_hears(const rf_bus *bus, size_t receiver, size_t source) {
  return (bus->receivers[receiver].hears & bit_of(source)) != 0;
}

void rf_bus_carrier(rf_bus *bus, size_t source, bool carrier, cycles_t at) {
  if (bus->edge_count == bus->edge_capacity) {
    size_t capacity = bus->edge_capacity ? 2 * bus->edge_capacity : 64;
    rf_edge *edges = realloc(bus->edges, capacity * sizeof *edges);
    if (!edges) abort();  // out of memory: nothing sensible is left to do
    bus->edges = edges;
    bus->edge_capacity = capacity;
  }
  size_t place = bus->edge_count++;
  for (; place > 0 && bus->edges[place - 1].at > at; place--) bus->edges[place] = bus->edges[place - 1];
  bus->edges[place] = (rf_edge){source, carrier, at};
}

static void jam(rf_bus *bus, size_t index, const fault_config *fault, cycles_t at, cycles_t end) {
  rf_source *source = &bus->sources[index];
  source->everywhere = !fault->has_position;
  source->x_m = fault->x_m;
  source->y_m = fault->y_m;
  source->jam_end = end;
  source->next_toggle = at;
  find_hearers(bus, index, at);
  bus->next_event = at < bus->next_event ? at : bus->next_event;
}

void rf_bus_jam(rf_bus *bus, size_t number, cycles_t at, cycles_t end) {
  jam(bus, bus->jams[number].source, bus->jams[number].fault, at, end);
}

int rf_bus_jam_now(rf_bus *bus, const fault_config *fault, cycles_t at, cycles_t end) {
  size_t index = bus->planned_count;
  while (index < bus->source_count && (bus->sources[index].active || bus->sources[index].next_toggle != NEVER)) index++;
  if (index == MAX_SOURCES) return -1;
  if (index == bus->source_count) init_source(bus, bus->source_count++);
  jam(bus, index, fault, at, end);
  return 0;
}

void rf_bus_move(rf_bus *bus, size_t source, double x_m, double y_m, cycles_t now) {
  bus->sources[source].x_m = x_m;
  bus->sources[source].y_m = y_m;
  find_hearers(bus, source, now);
  for (size_t i = 0; source < bus->board_count && i < bus->source_count; i++) find_hearing(bus, source, i, now);
}

void rf_bus_set_radio(rf_bus *bus, const radio_config *radio, cycles_t now) {
  take_radio(bus, radio, now);
  find_all_hearers(bus, now);
  bus->next_event = now < bus->next_event ? now : bus->next_event;
}

static uint64_t active_sources(const rf_bus *bus) {
  uint64_t active = 0;
  for (size_t i = 0; i < bus->source_count; i++)
    if (bus->sources[i].active) active |= bit_of(i);
  return active;
}

static void begin_transmission(rf_bus *bus, size_t index, cycles_t at) {
  uint64_t others = active_sources(bus);
  bus->sources[index].active = true;
  for (size_t r = 0; r < bus->board_count; r++) {
    uint64_t heard = bus->receivers[r].hears & (others | bit_of(index));
    if (rf_bus_hears(bus, r, index) && heard != bit_of(index))
      bus->listener.collision(bus->listener.context, r, heard, at + RF_DELAY);
  }
}

static void set_carrier(rf_bus *bus, size_t index, bool carrier, cycles_t at) {
  rf_source *source = &bus->sources[index];
  if (source->carrier == carrier) return;
  source->carrier = carrier;
  source->quiet_at = carrier ? NEVER : at + RF_QUIET_BITS * bus->bit_cycles;
  if (carrier && !source->active) begin_transmission(bus, index, at);
}

static void run_source(rf_bus *bus, size_t index, cycles_t now) {
  rf_source *source = &bus->sources[index];
  if (source->next_toggle <= now && now >= source->jam_end) {
    source->next_toggle = NEVER;
    set_carrier(bus, index, false, now);
  } else if (source->next_toggle <= now) {
    set_carrier(bus, index, prng_chance(&source->noise, 0.5), now);
    source->next_toggle = now + bus->bit_cycles;
  }
  if (source->quiet_at <= now) {
    source->quiet_at = NEVER;
    source->active = false;
  }
}

// The one of these sources that is heard best.
static size_t nearest(const rf_receiver *receiver, uint64_t sources) {
  size_t best = (size_t)__builtin_ctzll(sources);
  for (sources &= sources - 1; sources; sources &= sources - 1) {
    size_t index = (size_t)__builtin_ctzll(sources);
    if (receiver->metres[index] < receiver->metres[best]) best = index;
  }
  return best;
}

static bool burst_error(rf_bus *bus, rf_receiver *receiver, cycles_t now) {
  if (bus->radio.bursts.rate <= 0) return false;
  while (receiver->burst_change <= now) {
    receiver->in_burst = !receiver->in_burst;
    receiver->burst_change += burst_length(bus, receiver);
  }
  return receiver->in_burst && prng_chance(&receiver->bursts, bus->radio.bursts.rate_within);
}

static bool slot_error(rf_bus *bus, rf_receiver *receiver, uint64_t heard, cycles_t now) {
  double rate = bus->radio.bit_error_rate;
  if (bus->radio.distance_rate_count > 0) {
    double of_distance = propagation_error_rate(&bus->radio, receiver->metres[nearest(receiver, heard)]);
    rate += of_distance - 2 * rate * of_distance;  // one or the other; both together are none
  }
  return prng_chance(&receiver->errors, rate) != burst_error(bus, receiver, now);
}

// Bit errors fall into slots of one bit, from the first carrier heard until the last is gone. Noise comes between, but for
// who sends: its own carrier is the strongest of all.
static void run_slots(rf_bus *bus, rf_receiver *receiver, uint64_t heard, bool sends, cycles_t now) {
  bool changed = receiver->hearing != (heard != 0) || (sends && !heard);
  receiver->hearing = heard != 0;
  if (receiver->next_slot > now && !changed) return;
  if (heard) {
    receiver->flip = bus->has_errors && slot_error(bus, receiver, heard, now);
    receiver->next_slot = bus->has_errors ? now + bus->bit_cycles : NEVER;
  } else if (changed) {
    receiver->flip = false;
    receiver->next_slot = noise_start(bus, now);
  } else {
    receiver->flip = !receiver->flip;
    receiver->next_slot =
        now + 1 + (cycles_t)prng_exponential(&receiver->noise, CYCLES_PER_SECOND / bus->radio.noise.edges_per_s);
  }
}

// The sources heard that the receiver does not take for silence.
static uint64_t captured(const rf_bus *bus, const rf_receiver *receiver, uint64_t heard) {
  if (bus->capture_ratio <= 0 || (heard & (heard - 1)) == 0) return heard;
  size_t best = nearest(receiver, heard);
  double others = receiver->metres[nearest(receiver, heard & ~bit_of(best))];
  return others >= bus->capture_ratio * fmax(receiver->metres[best], NEAREST_M) ? bit_of(best) : heard;
}

static void update_receivers(rf_bus *bus, cycles_t now) {
  uint64_t active = active_sources(bus);
  uint64_t carriers = 0;
  for (size_t i = 0; i < bus->source_count; i++)
    if (bus->sources[i].carrier) carriers |= bit_of(i);
  for (size_t r = 0; r < bus->board_count; r++) {
    rf_receiver *receiver = &bus->receivers[r];
    uint64_t heard = receiver->hears & active;
    run_slots(bus, receiver, heard, (active & bit_of(r)) != 0, now);
    bool level = ((captured(bus, receiver, heard) & carriers) != 0) != receiver->flip;
    if (level != receiver->level) {
      receiver->level = level;
      bus->listener.level(bus->listener.context, r, level, now + RF_DELAY);
    }
  }
}

static cycles_t earliest(cycles_t a, cycles_t b) { return a < b ? a : b; }

static cycles_t next_own_event(const rf_bus *bus) {
  cycles_t next = NEVER;
  for (size_t i = 0; i < bus->source_count; i++)
    next = earliest(next, earliest(bus->sources[i].quiet_at, bus->sources[i].next_toggle));
  for (size_t i = 0; i < bus->board_count; i++) next = earliest(next, bus->receivers[i].next_slot);
  return next;
}

void rf_bus_advance(rf_bus *bus, cycles_t until) {
  size_t done = 0;
  for (;;) {
    cycles_t now = bus->next_event;
    if (done < bus->edge_count) now = earliest(now, bus->edges[done].at);
    if (now >= until) break;
    for (; done < bus->edge_count && bus->edges[done].at <= now; done++)
      set_carrier(bus, bus->edges[done].source, bus->edges[done].carrier, now);
    for (size_t i = 0; i < bus->source_count; i++) run_source(bus, i, now);
    update_receivers(bus, now);
    bus->next_event = next_own_event(bus);
  }
  if (done > 0) memmove(bus->edges, bus->edges + done, (bus->edge_count - done) * sizeof *bus->edges);
  bus->edge_count -= done;
}
