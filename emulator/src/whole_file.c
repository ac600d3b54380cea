// SPDX-License-Identifier: GPL-3.0-or-later
#include "whole_file.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

FILE *open_to_read(const char *path, const char **why) {
  struct stat status;
  FILE *file = fopen(path, "rbe");
  *why = NULL;
  if (!file || fstat(fileno(file), &status) != 0)
    *why = strerror(errno);
  else if (S_ISDIR(status.st_mode))
    *why = "it is a folder, not a file";
  else if (S_ISREG(status.st_mode) && status.st_size == 0)
    *why = "it is empty";
  if (!*why) return file;
  if (file) fclose(file);
  return NULL;
}

int whole_file_read(whole_file *result, const char *path, const char **why) {
  FILE *file = open_to_read(path, why);
  *result = (whole_file){0};
  if (!file) return -1;
  size_t capacity = 0;
  do {
    // A pipe does not tell its length.
    capacity = capacity * 2 + 65536;
    uint8_t *more = realloc(result->bytes, capacity);
    if (!more) break;
    result->bytes = more;
    result->length += fread(result->bytes + result->length, 1, capacity - result->length, file);
  } while (result->length == capacity);
  if (result->length == capacity || ferror(file)) *why = strerror(errno);
  fclose(file);
  if (*why) whole_file_release(result);
  return *why ? -1 : 0;
}

void whole_file_release(whole_file *file) {
  free(file->bytes);
  *file = (whole_file){0};
}

size_t byte_order_mark(const void *text, size_t length) {
  static const char MARK[] = "\xEF\xBB\xBF";
  size_t size = sizeof MARK - 1;
  return length >= size && memcmp(text, MARK, size) == 0 ? size : 0;
}
