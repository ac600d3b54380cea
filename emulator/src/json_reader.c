// SPDX-License-Identifier: GPL-3.0-or-later
#include "json_reader.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "suggest.h"

json_node json_root(json_reader *reader, json_t *value) { return (json_node){reader, value, ""}; }

static json_node child(const json_node *parent, json_t *value) {
  json_node node = {parent->reader, value, ""};
  memcpy(node.path, parent->path, sizeof node.path);
  return node;
}

static void extend_path(json_node *node, const char *format, ...) {
  size_t used = strlen(node->path);
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(node->path + used, sizeof node->path - used, format, arguments);
  va_end(arguments);
}

json_node json_member(const json_node *object, const char *key) {
  json_node node = child(object, json_object_get(object->value, key));
  extend_path(&node, "%s%s", node.path[0] ? "." : "", key);
  return node;
}

json_node json_element(const json_node *array, size_t index) {
  json_node node = child(array, json_array_get(array->value, index));
  extend_path(&node, "[%zu]", index);
  return node;
}

void json_fail(const json_node *node, const char *format, ...) {
  json_reader *reader = node->reader;
  if (json_failed(reader)) return;
  const char *path = node->path[0] ? node->path : reader->whole ? reader->whole : "the whole file";
  int used = snprintf(reader->error, sizeof reader->error, "%s: %s: ", reader->file, path);
  if (used < 0 || (size_t)used >= sizeof reader->error) return;
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(reader->error + used, sizeof reader->error - (size_t)used, format, arguments);
  va_end(arguments);
}

void json_expected(const json_node *node, const char *expected) {
  if (!node->value) {
    json_fail(node, "is missing; expected %s", expected);
    return;
  }
  char *found = json_dumps(node->value, JSON_ENCODE_ANY | JSON_COMPACT);
  json_fail(node, "expected %s, found %.60s", expected, found ? found : "something unprintable");
  free(found);
}

static bool listed(const char *key, const char *const *keys) {
  for (; *keys; keys++)
    if (strcmp(key, *keys) == 0) return true;
  return false;
}

static void list_words(char *text, size_t size, const char *const *words) {
  size_t used = 0;
  text[0] = '\0';
  for (size_t i = 0; words[i] && used < size; i++)
    used += (size_t)snprintf(text + used, size - used, "%s%s", i ? ", " : "", words[i]);
}

// "unknown key; did you mean x?" or, where nothing is near, what there is.
static void fail_unknown(const json_node *node, const char *what, const char *word, const char *const *words) {
  const char *near = suggest(word, words);
  char all[256];
  list_words(all, sizeof all, words);
  if (near)
    json_fail(node, "unknown %s \"%.40s\"; did you mean \"%s\"?", what, word, near);
  else
    json_fail(node, "unknown %s \"%.40s\"; expected one of: %s", what, word, all);
}

bool json_check_object(const json_node *node, const char *const *keys) {
  if (!json_is_object(node->value)) {
    json_expected(node, "an object { … }");
    return false;
  }
  const char *key;
  json_t *value;
  json_object_foreach(node->value, key, value) {
    if (!listed(key, keys)) {
      fail_unknown(node, "key", key, keys);
      return false;
    }
  }
  return true;
}

size_t json_array_length(const json_node *node) {
  if (!node->value) return 0;
  if (!json_is_array(node->value)) json_expected(node, "a list [ … ]");
  return json_array_size(node->value);
}

double json_number(const json_node *node, double min, double max, double otherwise) {
  if (!node->value) return otherwise;
  double number = json_number_value(node->value);
  if (json_is_number(node->value) && number >= min && number <= max) return number;
  char expected[80];
  snprintf(expected, sizeof expected, "a number from %g to %g", min, max);
  json_expected(node, expected);
  return otherwise;
}

bool json_flag(const json_node *node, bool otherwise) {
  if (!node->value) return otherwise;
  if (!json_is_boolean(node->value)) json_expected(node, "true or false");
  return json_is_true(node->value);
}

char *json_text(const json_node *node) {
  if (!node->value) return NULL;
  if (!json_is_string(node->value) || json_string_length(node->value) == 0) {
    json_expected(node, "a text in quotes");
    return NULL;
  }
  return strdup(json_string_value(node->value));
}

int json_choice(const json_node *node, const char *const *words) {
  if (!node->value) return -1;
  const char *text = json_string_value(node->value);
  for (int i = 0; text && words[i]; i++)
    if (strcmp(text, words[i]) == 0) return i;
  if (text) {
    fail_unknown(node, "value", text, words);
  } else {
    char all[256];
    list_words(all, sizeof all, words);
    json_expected(node, all);
  }
  return -1;
}
