// SPDX-License-Identifier: GPL-3.0-or-later
// A value over time, given by points.
#ifndef JAVINO_SERIES_H
#define JAVINO_SERIES_H

#include <stddef.h>

typedef struct {
  double t_s;
  double value;
} series_point;

// Points in rising order of time, at least one.
typedef struct {
  series_point *points;
  size_t count;
} series;

// The value at `t_s` on the line between the points around it; before the first point and after
// the last one, their values.
double series_linear(const series *values, double t_s);

// The value of the last point at or before `t_s`; before the first point, its value.
double series_step(const series *values, double t_s);

// The time of the first point after `t_s`, or infinity.
double series_next_change_s(const series *values, double t_s);

#endif
