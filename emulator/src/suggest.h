// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef JAVINO_SUGGEST_H
#define JAVINO_SUGGEST_H

// The word of the NULL-ended list that `typed` was probably meant to be (at most a third of its
// letters wrong, swapped, missing or too many), or NULL.
const char *suggest(const char *typed, const char *const *words);

#endif
