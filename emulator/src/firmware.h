// SPDX-License-Identifier: GPL-3.0-or-later
// Loads an ELF file that was built for a model's chip, or Intel HEX, and a boot loader beside it.
#ifndef JAVINO_FIRMWARE_H
#define JAVINO_FIRMWARE_H

#include <stddef.h>

#include "model.h"

struct avr_t;

// Returns 0, or -1 with one line in `error`.
int firmware_load(struct avr_t *avr, const model *m, const char *path, char *error, size_t error_size);

// Adds a boot loader, an Intel HEX file, with which the chip begins from now on after each reset.
// Returns 0, or -1 with one line in `error`.
int firmware_add_boot_loader(struct avr_t *avr, const model *m, const char *path, char *error, size_t error_size);

#endif
