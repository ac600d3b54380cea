// SPDX-License-Identifier: GPL-3.0-or-later
// Reads JSON strictly: each value is checked, and the first mistake is kept as one line that says
// file, key path, what was expected and what was found.
#ifndef JAVINO_JSON_READER_H
#define JAVINO_JSON_READER_H

#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>

typedef struct {
  const char *file;
  char error[512];    // empty while all is well
  const char *whole;  // what a mistake of no single key is in; NULL: the whole file
} json_reader;

// A value and the path that leads to it. The value is NULL where the file has none.
typedef struct {
  json_reader *reader;
  json_t *value;
  char path[128];
} json_node;

json_node json_root(json_reader *reader, json_t *value);
json_node json_member(const json_node *object, const char *key);
json_node json_element(const json_node *array, size_t index);

static inline bool json_given(const json_node *node) { return node->value != NULL; }

static inline bool json_failed(const json_reader *reader) { return reader->error[0] != '\0'; }

// Records that `node` is not what was `expected`; later failures do not replace the first.
void json_expected(const json_node *node, const char *expected);

// Records a mistake in words of its own.
void json_fail(const json_node *node, const char *format, ...) __attribute__((format(printf, 2, 3)));

// Checks that `node` is an object with no keys but those of the NULL-ended list.
bool json_check_object(const json_node *node, const char *const *keys);

// Checks that `node` is an array; returns the number of its elements, 0 where it is absent.
size_t json_array_length(const json_node *node);

// These return the value, or `otherwise` where it is absent.
double json_number(const json_node *node, double min, double max, double otherwise);
bool json_flag(const json_node *node, bool otherwise);

// Returns a copy for the caller to free, or NULL where the value is absent or wrong.
char *json_text(const json_node *node);

// Returns the index in the NULL-ended list, or -1 where the value is absent or wrong.
int json_choice(const json_node *node, const char *const *words);

#endif
