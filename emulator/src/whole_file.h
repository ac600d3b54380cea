// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef JAVINO_WHOLE_FILE_H
#define JAVINO_WHOLE_FILE_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

// All bytes of a file.
typedef struct {
  uint8_t *bytes;
  size_t length;
} whole_file;

// Opens a file to be read. Returns NULL with the reason in `why` if it cannot be read, is a folder, or has no byte.
FILE *open_to_read(const char *path, const char **why);

// Reads a file to its end. Returns 0, or -1 as `open_to_read`.
int whole_file_read(whole_file *file, const char *path, const char **why);

void whole_file_release(whole_file *file);

// The length of the byte order mark that some editors put before a text, or 0.
size_t byte_order_mark(const void *text, size_t length);

#endif
