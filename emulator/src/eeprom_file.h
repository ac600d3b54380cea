// SPDX-License-Identifier: GPL-3.0-or-later
// A file that keeps a board's EEPROM.
#ifndef JAVINO_EEPROM_FILE_H
#define JAVINO_EEPROM_FILE_H

#include <stddef.h>
#include <stdint.h>

struct avr_t;

#define MAX_EEPROM_SIZE 4096

typedef struct {
    const char *path;
    int size;                       // bytes
    const uint8_t *live;            // the chip's own
    uint8_t saved[MAX_EEPROM_SIZE]; // what the file holds
} eeprom_file;

// Loads the file into the chip, whose EEPROM has `size` bytes; without a file, makes one of what the chip holds.
// Returns 0, or -1 with one line in `error`: unreadable, of the wrong size, or not to be written.
int eeprom_file_open(eeprom_file *file, struct avr_t *avr, int size, const char *path, char *error,
                     size_t error_size);

// Writes the file, in one piece, if the chip's bytes are others than the file's.
// Returns 0, or -1 with one line in `error`.
int eeprom_file_save(eeprom_file *file, char *error, size_t error_size);

#endif
