// SPDX-License-Identifier: GPL-3.0-or-later
// The effects of commands on a run.
#ifndef JAVINO_EMULATION_COMMAND_H
#define JAVINO_EMULATION_COMMAND_H

#include "command.h"
#include "emulation.h"

// Performs the command at once, and writes it to the trace. Returns 0, or -1 with one line in `error`.
int emulation_command(emulation *e, const command *c, char *error, size_t error_size);

#endif
