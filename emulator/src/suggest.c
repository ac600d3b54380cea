// SPDX-License-Identifier: GPL-3.0-or-later
#include "suggest.h"

#include <ctype.h>
#include <stddef.h>
#include <string.h>

#define MAX_WORD 31

static int min3(int a, int b, int c) {
  int least = a < b ? a : b;
  return least < c ? least : c;
}

// Edit distance with swaps of neighbours (optimal string alignment), upper and lower case alike.
static int distance(const char *a, const char *b) {
  int table[MAX_WORD + 1][MAX_WORD + 1];
  int rows = (int)strlen(a);
  int columns = (int)strlen(b);
  for (int i = 0; i <= rows; i++)
    for (int j = 0; j <= columns; j++) {
      if (i == 0 || j == 0) {
        table[i][j] = i + j;
        continue;
      }
      int differ = tolower((unsigned char)a[i - 1]) != tolower((unsigned char)b[j - 1]);
      table[i][j] = min3(table[i - 1][j] + 1, table[i][j - 1] + 1, table[i - 1][j - 1] + differ);
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] && table[i - 2][j - 2] + 1 < table[i][j])
        table[i][j] = table[i - 2][j - 2] + 1;
    }
  return table[rows][columns];
}

const char *suggest(const char *typed, const char *const *words) {
  const char *best = NULL;
  size_t length = strlen(typed);
  int best_distance = (int)length / 3 + 1;
  if (length > MAX_WORD) return NULL;
  for (; *words; words++) {
    int d = strlen(*words) <= MAX_WORD ? distance(typed, *words) : MAX_WORD;
    if (d < best_distance || (d == best_distance && !best && length > 2)) {
      best = *words;
      best_distance = d;
    }
  }
  return best;
}
