// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator_log.h"

#include <stdio.h>
#include <string.h>

#include <simavr/sim_avr.h>

// simavr's logger is one for the whole process, and so is this.
static unsigned long warnings;

// Takes colours (ESC [ … m) and the line's end away.
static void make_plain(char *text) {
  char *to = text;
  for (const char *from = text; *from && *from != '\n'; from++) {
    if (*from == '\033')
      from += strcspn(from, "m");
    else
      *to++ = *from;
    if (!*from) break;
  }
  *to = '\0';
}

static void log_warning(struct avr_t *avr, const int level, const char *format, va_list arguments) {
  char text[300];
  (void)avr;
  if (level != LOG_ERROR && level != LOG_WARNING) return;
  if (++warnings > SIMULATOR_LOG_MAX) return;
  vsnprintf(text, sizeof text, format, arguments);
  make_plain(text);
  fprintf(stderr, "javino-emulator: simavr: %s\n", text);
}

void simulator_log_install(void) { avr_global_logger_set(log_warning); }

unsigned long simulator_log_suppressed(void) { return warnings > SIMULATOR_LOG_MAX ? warnings - SIMULATOR_LOG_MAX : 0; }
