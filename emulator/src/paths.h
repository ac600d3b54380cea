// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef JAVINO_PATHS_H
#define JAVINO_PATHS_H

#include <stdbool.h>
#include <stdio.h>

// Makes the folders that `path` lies in, as far as they are missing.
// Returns 0, or -1 with errno set.
int make_folders_for(const char *path);

// Opens a file that only its user may read, to write it anew or to add to it. Returns NULL with errno set.
FILE *open_private(const char *path, bool add);

#endif
