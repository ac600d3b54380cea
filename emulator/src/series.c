// SPDX-License-Identifier: GPL-3.0-or-later
#include "series.h"

#include <math.h>

// How many points are at or before t_s.
static size_t points_until(const series *values, double t_s) {
  size_t count = 0;
  while (count < values->count && values->points[count].t_s <= t_s) count++;
  return count;
}

double series_step(const series *values, double t_s) {
  size_t passed = points_until(values, t_s);
  return values->points[passed ? passed - 1 : 0].value;
}

double series_linear(const series *values, double t_s) {
  size_t passed = points_until(values, t_s);
  if (passed == 0 || passed == values->count) return series_step(values, t_s);
  const series_point *before = &values->points[passed - 1];
  const series_point *after = &values->points[passed];
  double share = (t_s - before->t_s) / (after->t_s - before->t_s);
  return before->value + share * (after->value - before->value);
}

double series_next_change_s(const series *values, double t_s) {
  size_t passed = points_until(values, t_s);
  return passed < values->count ? values->points[passed].t_s : INFINITY;
}
