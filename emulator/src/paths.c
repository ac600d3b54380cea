// SPDX-License-Identifier: GPL-3.0-or-later
#include "paths.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

int make_folders_for(const char *path) {
  char *copy = strdup(path);
  int result = copy ? 0 : -1;
  for (char *slash = copy ? strchr(copy + 1, '/') : NULL; slash && result == 0; slash = strchr(slash + 1, '/')) {
    *slash = '\0';
    if (mkdir(copy, 0777) != 0 && errno != EEXIST) result = -1;
    *slash = '/';
  }
  free(copy);
  return result;
}

FILE *open_private(const char *path, bool add) {
  int descriptor = open(path, O_WRONLY | O_CREAT | O_CLOEXEC | (add ? O_APPEND : O_TRUNC), S_IRUSR | S_IWUSR);
  if (descriptor < 0) return NULL;
  // It may have been there, readable by others.
  FILE *file = fchmod(descriptor, S_IRUSR | S_IWUSR) == 0 ? fdopen(descriptor, add ? "a" : "w") : NULL;
  if (!file) close(descriptor);
  return file;
}
