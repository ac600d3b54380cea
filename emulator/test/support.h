// SPDX-License-Identifier: GPL-3.0-or-later
// Helpers that the tests share: a scratch folder, scenarios from text, emulations whose trace can be asked.
#ifndef JAVINO_TEST_SUPPORT_H
#define JAVINO_TEST_SUPPORT_H

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

extern "C" {
#include <jansson.h>

#include "emulation.h"
#include "emulation_command.h"
#include "firmware.h"
#include "scenario.h"
#include "simulator_log.h"
}

const cycles_t BIT = CYCLES_PER_SECOND / 2000;  // on the air
const std::string HELLO = "2f2f2f2f43414645417748656c6c6f21";

// A folder that is gone at the end of the test.
class Scratch {
 public:
  Scratch();
  ~Scratch();
  std::string path(const std::string &name) const { return folder + "/" + name; }
  std::string write(const std::string &name, const std::string &text) const;

  std::string folder;
};

std::string read_text(const std::string &path);
bool exists(const std::string &path);

// The JSON file under test/vectors; the caller's for good.
json_t *load_vectors(const std::string &name);
// Puts the paths of the test programs in the place of @program.
std::string with_programs(std::string json);
std::vector<uint8_t> from_hex(const std::string &hex);
std::string text_of(const json_t *object, const char *key);

// One line of a trace.
struct Event {
  double t;
  std::string board, event;
  json_t *fields;
  std::string text(const char *key) const { return text_of(fields, key); }
  long long number(const char *key) const { return json_integer_value(json_object_get(fields, key)); }
  double real(const char *key) const { return json_number_value(json_object_get(fields, key)); }
  bool flag(const char *key) const { return json_is_true(json_object_get(fields, key)); }
};

// Runs a scenario as fast as possible and reads its trace.
class Emulation {
 public:
  // `json` may say @program for the path of one of the test programs. Played ports are no ptys.
  Emulation(const Scratch &scratch, const std::string &json, uint64_t seed = 1, bool played = false);
  ~Emulation();

  void run_until(double seconds);
  // Performs a command; returns the error, "" if none.
  std::string command(const std::string &line);
  // Runs millisecond by millisecond, exchanging with the hosts, until `done` says so.
  bool run_while_waiting(double seconds, const std::function<bool()> &done);
  void close();

  std::vector<Event> events(const std::string &board, const std::string &event);
  std::vector<Event> events(const std::string &event) { return events("", event); }
  std::string trace_text();

  emulation e;

 private:
  scenario config;
  trace out;
  std::string trace_path;
  std::vector<json_t *> parsed;
  bool open = true;
};

#endif
