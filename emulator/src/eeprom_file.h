// SPDX-License-Identifier: GPL-3.0-or-later
// A file that keeps a board's EEPROM. It is locked (flock) while it is open, so that no two boards keep theirs in it.
#ifndef JAVINO_EEPROM_FILE_H
#define JAVINO_EEPROM_FILE_H

#include <stddef.h>
#include <stdint.h>

struct avr_t;

#define MAX_EEPROM_SIZE 4096

typedef struct {
  const char *path;
  int size;                        // bytes
  const uint8_t *live;             // the chip's own; NULL where no file is open
  int lock;                        // descriptor of the file, which holds its lock
  uint8_t saved[MAX_EEPROM_SIZE];  // what the file holds
} eeprom_file;

// Loads the file into the chip, whose EEPROM has `size` bytes; without a file, makes one of what the chip holds.
// Returns 0, or -1 with one line in `error`: unreadable, of the wrong size, not to be written, or used by another.
int eeprom_file_open(eeprom_file *file, struct avr_t *avr, int size, const char *path, char *error, size_t error_size);

// Writes the file, in one piece, if the chip's bytes are others than the file's.
// Returns 0, or -1 with one line in `error`.
int eeprom_file_save(eeprom_file *file, char *error, size_t error_size);

// Lets go of the file, if one is open.
void eeprom_file_close(eeprom_file *file);

#endif
