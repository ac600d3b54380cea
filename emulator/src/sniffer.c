// SPDX-License-Identifier: GPL-3.0-or-later
#include "sniffer.h"

#include <stdlib.h>
#include <string.h>

#include "frame_view.h"
#include "utf8.h"

// How much later than the end of a packet a receiver's decoder may tell it.
#define ARRIVAL_BITS 8
#define CYCLES_PER_HOUR ((cycles_t)3600 * CYCLES_PER_SECOND)

// The source behind the boards' is the injector's.
static const char *board_name(const sniffer *s, size_t board) {
  return board < s->config->board_count ? s->config->boards[board].name : INJECTOR;
}

static void write_message(trace *t, const frame_view *view) {
  trace_flag(t, "sealed", view->sealed);
  if (!view->sealed && utf8_valid(view->message, view->message_length))
    trace_utf8(t, "content", view->message, view->message_length);
}

static void write_fragment(trace *t, const frame_view *view) {
  trace_count(t, "id", (uint64_t)view->fragment_id);
  trace_count(t, "index", (uint64_t)view->fragment_index);
  trace_flag(t, "asks", view->asks);
}

static void write_frame(trace *t, const frame_view *view) {
  trace_utf8(t, "destination", view->destination, 4);
  trace_utf8(t, "origin", view->origin, 4);
  trace_text(t, "kind", frame_kind_text(view->kind));
  switch (view->kind) {
    case KIND_FRAGMENT: write_fragment(t, view); break;
    case KIND_ACKNOWLEDGEMENT: trace_text(t, "answers", frame_answer_text(view)); break;
    default: write_message(t, view); break;
  }
}

static void write_packet(trace *t, uint64_t number, const line_packet *packet, const char *radio) {
  frame_view view;
  if (number != 0) trace_count(t, "packet", number);
  trace_hex(t, "payload", packet->payload, packet->length);
  if (frame_view_read(&view, packet->payload, packet->length) == 0)
    write_frame(t, &view);
  else
    trace_text(t, "kind", "no frame");
  if (packet->path % LINE_HOPS != 0) trace_count(t, "hops", packet->path % LINE_HOPS);
  if (packet->path >= LINE_HOPS) trace_count(t, "distance", packet->path / LINE_HOPS - 1);
  if (packet->trailer != LINE_NO_TRAILER) trace_text(t, "trailer", line_trailer_text(packet->trailer));
  if (radio) trace_text(t, "radio", radio);
  trace_count(t, "bits", packet->bits);
  trace_time(t, "start", packet->start);
  trace_time(t, "end", packet->end);
}

static void expect(sniffer_station *station, size_t source, const line_packet *packet) {
  sniffer *s = station->owner;
  if (station->expected_count == SNIFFER_MAX_EXPECTED) {
    station->counters.not_followed++;
    return;
  }
  sniffer_expected *expected = &station->expected[station->expected_count++];
  expected->source = source;
  expected->number = station->heard = s->stations[source].sending;
  expected->start = packet->start;
  expected->end = packet->end;
  expected->deadline = packet->end + RF_DELAY + (cycles_t)(ARRIVAL_BITS * s->bit_cycles);
  expected->length = packet->length;
  expected->path = packet->path;
  memcpy(expected->payload, packet->payload, packet->length);
  if (expected->deadline < s->next_deadline) s->next_deadline = expected->deadline;
}

// Receivers have a packet before its trailer has ended.
static void tx_whole(void *context, const line_packet *packet) {
  sniffer_station *station = context;
  sniffer *s = station->owner;
  station->sending = ++s->packets;
  for (size_t r = 0; r < s->config->board_count; r++)
    if (rf_bus_hears(s->bus, r, station->board)) expect(&s->stations[r], station->board, packet);
}

// Adds a packet's time to that of each hour in which it was on the air.
static void add_airtime(sniffer_station *station, cycles_t start, cycles_t end) {
  size_t hours = (size_t)(end / CYCLES_PER_HOUR) + 1;
  if (hours > station->hours) {
    double *grown = realloc(station->airtime_s, hours * sizeof *grown);
    if (!grown) {
      station->owner->out->failed = true;
      return;
    }
    for (size_t i = station->hours; i < hours; i++) grown[i] = 0;
    station->airtime_s = grown;
    station->hours = hours;
  }
  while (start < end) {
    size_t hour = (size_t)(start / CYCLES_PER_HOUR);
    cycles_t next = (hour + 1) * CYCLES_PER_HOUR;
    cycles_t until = next < end ? next : end;
    station->airtime_s[hour] += cycles_to_seconds(until - start);
    start = until;
  }
}

static void tx_ended(void *context, const line_packet *packet) {
  sniffer_station *station = context;
  sniffer *s = station->owner;
  station->counters.sent++;
  add_airtime(station, packet->start, packet->end);
  trace_begin(s->out, packet->end, board_name(s, station->board), "rf-tx");
  write_packet(s->out, station->sending, packet, s->config->radio.module.name);
  if (s->ending) trace_flag(s->out, "cut", true);
  trace_end(s->out);
}

static void tx_damaged(void *context, line_error error, cycles_t at) {
  sniffer_station *station = context;
  (void)error;
  (void)at;
  station->counters.undecodable++;
}

static void forget(sniffer_station *station, size_t index) {
  station->expected_count--;
  memmove(&station->expected[index], &station->expected[index + 1],
          (station->expected_count - index) * sizeof station->expected[0]);
}

static int find_expected(const sniffer_station *station, const line_packet *packet) {
  for (size_t i = 0; i < station->expected_count; i++)
    if (station->expected[i].length == packet->length && station->expected[i].path == packet->path &&
        memcmp(station->expected[i].payload, packet->payload, packet->length) == 0)
      return (int)i;
  return -1;
}

static void rx_ended(void *context, const line_packet *packet) {
  sniffer_station *station = context;
  sniffer *s = station->owner;
  int index = find_expected(station, packet);
  uint64_t number = index >= 0 ? station->expected[index].number : 0;
  station->counters.received++;
  trace_begin(s->out, packet->end, board_name(s, station->board), "rf-rx");
  if (index >= 0) {
    trace_text(s->out, "from", board_name(s, station->expected[index].source));
    forget(station, (size_t)index);
  }
  write_packet(s->out, number, packet, s->config->radio.module.name);
  trace_end(s->out);
}

static void rx_damaged(void *context, line_error error, cycles_t at) {
  sniffer_station *station = context;
  station->last_error = error;
  station->last_error_at = at;
}

int sniffer_init(sniffer *s, const scenario *config, const rf_bus *bus, trace *out) {
  *s = (sniffer){.config = config, .bus = bus, .out = out, .next_deadline = NEVER};
  s->bit_cycles = CYCLES_PER_SECOND / config->radio.bit_rate;
  s->stations = calloc(config->board_count + 1, sizeof *s->stations);
  if (!s->stations) return -1;
  for (size_t i = 0; i <= config->board_count; i++) {
    sniffer_station *station = &s->stations[i];
    station->owner = s;
    station->board = i;
    line_decoder_init(&station->tx, config->radio.bit_rate, (line_listener){station, tx_whole, tx_ended, tx_damaged});
    station->tx.at_sender = true;
    line_decoder_init(&station->rx, config->radio.bit_rate, (line_listener){station, NULL, rx_ended, rx_damaged});
  }
  return 0;
}

void sniffer_end(sniffer *s) {
  if (!s->stations) return;
  s->ending = true;
  for (size_t i = 0; i <= s->config->board_count; i++) line_decoder_end(&s->stations[i].tx);
  for (size_t i = 0; i < s->config->board_count; i++) line_decoder_end(&s->stations[i].rx);
}

void sniffer_release(sniffer *s) {
  for (size_t i = 0; s->stations && i <= s->config->board_count; i++) free(s->stations[i].airtime_s);
  free(s->stations);
}

void sniffer_tx_edge(sniffer *s, size_t board, bool level, cycles_t at) {
  line_decoder_edge(&s->stations[board].tx, level, at);
}

void sniffer_rx_edge(sniffer *s, size_t board, bool level, cycles_t at) {
  line_decoder_edge(&s->stations[board].rx, level, at);
}

void sniffer_collision(sniffer *s, size_t receiver, uint64_t sources, cycles_t at) {
  bool first = true;
  s->stations[receiver].counters.collisions++;
  trace_begin(s->out, at, board_name(s, receiver), "rf-collision");
  trace_list_begin(s->out, "boards");
  for (size_t source = 0; source < s->bus->source_count; source++) {
    if (!(sources >> source & 1)) continue;
    trace_list_text(s->out, source <= s->bus->board_count ? board_name(s, source) : "jam", first);
    first = false;
  }
  trace_list_end(s->out);
  trace_end(s->out);
}

static void report_damaged(sniffer_station *station, const sniffer_expected *lost, const char *why) {
  sniffer *s = station->owner;
  station->counters.damaged++;
  trace_begin(s->out, lost->deadline, board_name(s, station->board), "rf-damaged");
  trace_text(s->out, "from", board_name(s, lost->source));
  trace_count(s->out, "packet", lost->number);
  trace_text(s->out, "why", why);
  trace_time(s->out, "start", lost->start);
  trace_time(s->out, "end", lost->end);
  trace_end(s->out);
}

static void check_deadlines(sniffer *s, cycles_t now) {
  s->next_deadline = NEVER;
  for (size_t r = 0; r < s->config->board_count; r++) {
    sniffer_station *station = &s->stations[r];
    for (size_t i = 0; i < station->expected_count;) {
      cycles_t deadline = station->expected[i].deadline;
      if (deadline < now) {
        const sniffer_expected *lost = &station->expected[i];
        report_damaged(station, lost,
                       station->last_error_at > lost->start ? line_error_text(station->last_error) : "no start symbol");
        forget(station, i);
        continue;
      }
      if (deadline < s->next_deadline) s->next_deadline = deadline;
      i++;
    }
  }
}

void sniffer_module_packet(sniffer *s, size_t source, const line_packet *packet, uint64_t missed) {
  sniffer_station *sender = &s->stations[source];
  if (packet->length == 0) {
    sender->counters.undecodable++;
    return;
  }
  sender->sending = ++s->packets;
  tx_ended(sender, packet);
  for (size_t r = 0; r < s->config->board_count; r++) {
    sniffer_station *station = &s->stations[r];
    if (!rf_bus_hears(s->bus, r, source)) continue;
    if (missed >> r & 1) {
      station->heard = sender->sending;
      sniffer_expected lost = {.source = source, .number = sender->sending, .start = packet->start, .end = packet->end};
      lost.deadline = packet->end;
      report_damaged(station, &lost, "a piece is lost");
      continue;
    }
    expect(station, source, packet);
    rx_ended(station, packet);
  }
}

void sniffer_advance_tx(sniffer *s, cycles_t now) {
  for (size_t i = 0; i <= s->config->board_count; i++) line_decoder_advance(&s->stations[i].tx, now);
}

void sniffer_advance_rx(sniffer *s, cycles_t now) {
  for (size_t i = 0; i < s->config->board_count; i++) line_decoder_advance(&s->stations[i].rx, now);
  if (s->next_deadline < now) check_deadlines(s, now);
}
