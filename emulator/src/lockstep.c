// SPDX-License-Identifier: GPL-3.0-or-later
#include "lockstep.h"

#include <string.h>

#include "control.h"
#include "hex.h"

// Cycles are counted up to here.
#define LAST_CYCLE INT64_MAX
#define MAX_QUOTED 60

void lockstep_init(lockstep *l, emulation *e, cycles_t end, lockstep_listener listener, FILE *answers) {
  *l = (lockstep){.e = e, .end = end, .listener = listener, .answers = answers, .number = 1};
  for (size_t i = 0; i < e->node_count; i++) l->ports[i].there = e->nodes[i].port.master >= 0;
}

static lockstep_state refuse(lockstep *l, const char *expected, const char *found) {
  char quoted[MAX_QUOTED + 1];
  size_t length = strnlen(found, MAX_QUOTED);
  for (size_t i = 0; i < length; i++) quoted[i] = found[i] >= ' ' && found[i] <= '~' ? found[i] : '?';
  quoted[length] = '\0';
  snprintf(l->error, sizeof l->error, "standard input, line %lu: expected %s, found \"%s\"", l->number, expected,
           quoted);
  return LOCKSTEP_REFUSED;
}

static lockstep_state fail(lockstep *l, const char *why) {
  snprintf(l->error, sizeof l->error, "%s", why);
  return LOCKSTEP_FAILED;
}

static lockstep_state answered(lockstep *l) {
  putc('\n', l->answers);
  return fflush(l->answers) == 0 ? LOCKSTEP_ON : fail(l, "the answers cannot be written any more");
}

static lockstep_state answer(lockstep *l, const char *text) {
  fputs(text, l->answers);
  return answered(l);
}

// How many of a board's bytes are handed over now.
static size_t ready(pty *p, cycles_t now) {
  size_t count = p->out_length - bridge_held(&p->usb, now);
  bool passed_on = p->usb.latency > 0 || count >= LOCKSTEP_MANY || now >= p->put_at + LOCKSTEP_QUIET ||
                   memchr(p->out, 0, count) != NULL;
  return passed_on ? count : 0;
}

// Whether its host has lost the port and was not told.
static bool lost(const lockstep_port *known, const pty *p) { return known->open && !p->open; }

static bool has_news(lockstep *l, size_t board) {
  pty *p = &l->e->nodes[board].port;
  const lockstep_port *known = &l->ports[board];
  return lost(known, p) || known->there != (p->master >= 0) || ready(p, l->e->now) > 0;
}

static bool any_news(lockstep *l) {
  bool any = false;
  for (size_t i = 0; i < l->e->node_count; i++) any |= has_news(l, i);
  return any;
}

static bool waits_for_board(const pty *p) { return p->in_start < p->in_end; }

// When the next bytes are handed over if no board does anything.
static cycles_t next_ready(lockstep *l) {
  cycles_t next = NEVER;
  for (size_t i = 0; i < l->e->node_count; i++) {
    pty *p = &l->e->nodes[i].port;
    cycles_t due = NEVER;
    if (waits_for_board(p))
      due = l->e->now;
    else if (bridge_held(&p->usb, l->e->now) > 0)
      due = p->usb.timer_end;
    else if (p->out_length > 0)
      due = p->put_at + LOCKSTEP_QUIET;
    next = due < next ? due : next;
  }
  return next;
}

// Runs one turn, or several while nothing happens. All turns begin and end at multiples of RF_STEP, so that they are the
// same however many commands the run is made of.
static int run_turn(lockstep *l, cycles_t until) {
  emulation *e = l->e;
  cycles_t next = emulation_next_event(e), due = next_ready(l);
  next = due < next ? due : next;
  next -= next % RF_STEP;
  if (next < e->now + RF_STEP) next = e->now + RF_STEP;
  if (emulation_run(e, next < until ? next : until) != 0) return -1;
  bool waits = false;
  for (size_t i = 0; i < e->node_count; i++) waits |= waits_for_board(&e->nodes[i].port);
  if (waits) emulation_exchange(e);
  return 0;
}

static void play(lockstep *l, size_t board, pty_change change, size_t gave) {
  static const uint8_t NONE[1];
  pty_play(&l->e->nodes[board].port, change, NONE, 0, gave);
  emulation_exchange(l->e);
}

static void tell_port(lockstep *l, size_t board) {
  pty *p = &l->e->nodes[board].port;
  lockstep_port *known = &l->ports[board];
  bool there = p->master >= 0, gone = lost(known, p) || (known->there && !there);
  if (gone) fprintf(l->answers, " %zu unplugged", board);
  if (there && (gone || !known->there)) fprintf(l->answers, " %zu plugged", board);
  *known = (lockstep_port){there, p->open};
  size_t count = ready(p, l->e->now);
  if (count == 0) return;
  fprintf(l->answers, " %zu ", board);
  for (size_t i = 0; i < count; i++) fprintf(l->answers, "%02x", p->out[i]);
  play(l, board, PTY_SAME, count);
}

static lockstep_state tell(lockstep *l) {
  fprintf(l->answers, "%llu", (unsigned long long)l->e->now);
  for (size_t i = 0; i < l->e->node_count; i++)
    if (has_news(l, i)) tell_port(l, i);
  lockstep_state state = answered(l);
  return state == LOCKSTEP_ON && l->e->now >= l->end ? LOCKSTEP_ENDED : state;
}

// Reads a whole number. Returns 0, or -1 where the text is none, or it is above `last`.
static int read_number(uint64_t *number, const char *text, uint64_t last) {
  *number = 0;
  for (const char *digit = text; *digit; digit++) {
    uint64_t value = (uint64_t)(*digit - '0');
    if (value > 9 || value > last || *number > (last - value) / 10) return -1;
    *number = 10 * *number + value;
  }
  return *text ? 0 : -1;
}

static lockstep_state run(lockstep *l, const char *text) {
  uint64_t until;
  if (read_number(&until, text, LAST_CYCLE) != 0) return refuse(l, "a cycle, 0 to 9223372036854775807", text);
  until += RF_STEP - 1;
  until -= until % RF_STEP;
  if (until > l->end) until = l->end;
  while (l->e->now < until && !any_news(l)) {
    if (run_turn(l, until) != 0) return fail(l, l->e->error);
    if (l->e->now < l->next_pass) continue;
    l->next_pass = l->e->now + LOCKSTEP_PASS;
    if (!l->listener.pass(l->listener.context)) return LOCKSTEP_ENDED;
  }
  return tell(l);
}

static lockstep_state open_port(lockstep *l, size_t board, const char *text) {
  if (*text) return refuse(l, "nothing behind the board", text);
  if (l->ports[board].open) return refuse(l, "a port that no host has open", l->e->nodes[board].config->name);
  play(l, board, PTY_OPENED, 0);
  l->ports[board].open = true;
  return answer(l, "ok");
}

static lockstep_state close_port(lockstep *l, size_t board, const char *text) {
  if (*text) return refuse(l, "nothing behind the board", text);
  if (!l->ports[board].open) return refuse(l, "a port that a host has open", l->e->nodes[board].config->name);
  play(l, board, PTY_CLOSED, 0);
  l->ports[board].open = false;
  return answer(l, "ok");
}

static lockstep_state write_port(lockstep *l, size_t board, const char *text) {
  uint8_t bytes[PTY_BUFFER];
  pty *p = &l->e->nodes[board].port;
  int length = hex_read(bytes, sizeof bytes, text);
  if (length <= 0) return refuse(l, "1 to 4096 bytes in hexadecimal digits", text);
  if (!l->ports[board].open) return refuse(l, "a port that a host has open", l->e->nodes[board].config->name);
  size_t room = pty_room(p), taken = (size_t)length < room ? (size_t)length : room;
  pty_play(p, PTY_SAME, bytes, taken, 0);
  emulation_exchange(l->e);
  fprintf(l->answers, "%zu", taken);
  return answered(l);
}

// Ends a word at the space behind it. Returns what follows, empty where nothing does.
static char *cut(char *word) {
  char *space = strchr(word, ' ');
  if (!space) return word + strlen(word);
  *space = '\0';
  return space + 1;
}

static lockstep_state use_port(lockstep *l, lockstep_state (*use)(lockstep *, size_t, const char *), char *text) {
  const emulation *e = l->e;
  const char *rest = cut(text);
  uint64_t board;
  if (read_number(&board, text, e->node_count - 1) != 0 || !e->nodes[board].config->port)
    return refuse(l, "the number of a board with a port, from 0", text);
  const pty *p = &e->nodes[board].port;
  if (p->master < 0 || lost(&l->ports[board], p)) return answer(l, "unplugged");
  return use(l, board, rest);
}

static lockstep_state command(lockstep *l) {
  char error[512], reply[CONTROL_MAX_REPLY];
  bool ok = l->listener.perform(l->listener.context, l->line, l->length, error, sizeof error) == 0;
  size_t length = control_reply(reply, ok ? NULL : error);
  reply[length - 1] = '\0';
  return answer(l, reply);
}

static lockstep_state perform(lockstep *l) {
  static const char COMMANDS[] = "run, open, close, write or {";
  l->line[l->length] = '\0';
  if (l->line[0] == '{') return command(l);
  if (strlen(l->line) < l->length) return refuse(l, "no byte 0x00", l->line);
  char *rest = cut(l->line);
  if (strcmp(l->line, "run") == 0) return run(l, rest);
  if (strcmp(l->line, "open") == 0) return use_port(l, open_port, rest);
  if (strcmp(l->line, "close") == 0) return use_port(l, close_port, rest);
  if (strcmp(l->line, "write") == 0) return use_port(l, write_port, rest);
  return refuse(l, COMMANDS, l->line);
}

lockstep_state lockstep_take(lockstep *l, const char *bytes, size_t length) {
  for (const char *byte = bytes; byte < bytes + length; byte++) {
    if (*byte != '\n' && l->length == LOCKSTEP_MAX_LINE) {
      l->line[l->length] = '\0';
      return refuse(l, "at most 8208 bytes in a line", l->line);
    }
    if (*byte != '\n') {
      l->line[l->length++] = *byte;
      continue;
    }
    lockstep_state state = perform(l);
    if (state != LOCKSTEP_ON) return state;
    l->length = 0;
    l->number++;
  }
  return LOCKSTEP_ON;
}

lockstep_state lockstep_finish(lockstep *l) {
  l->line[l->length] = '\0';
  return l->length == 0 ? LOCKSTEP_ENDED : refuse(l, "the end of the line", l->line);
}
