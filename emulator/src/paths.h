// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef JAVINO_PATHS_H
#define JAVINO_PATHS_H

#include <stdbool.h>

// Makes the folders that `path` lies in, as far as they are missing.
// Returns 0, or -1 with errno set.
int make_folders_for(const char *path);

// Makes a file that only its user may read, in the place of one that is there, or with `add` opens that to add to it.
// All that holds keys is opened by this. It follows no link, and leaves nothing where permissions cannot be kept.
// Returns a descriptor, or -1 with errno set.
int open_private(const char *path, bool add);

// Lets nobody but its user read an open file. Returns 0, or -1 with errno set.
int keep_private(int descriptor);

// The meaning of errno after one of the two has failed.
const char *private_problem(void);

#endif
