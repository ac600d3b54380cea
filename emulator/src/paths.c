// SPDX-License-Identifier: GPL-3.0-or-later
#include "paths.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

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
