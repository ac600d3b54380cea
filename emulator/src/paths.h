// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef JAVINO_PATHS_H
#define JAVINO_PATHS_H

// Makes the folders that `path` lies in, as far as they are missing.
// Returns 0, or -1 with errno set.
int make_folders_for(const char *path);

#endif
