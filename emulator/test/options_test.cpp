// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <string>
#include <vector>

extern "C" {
#include "options.h"
}

static std::string parse(options *o, std::vector<std::string> arguments) {
  std::vector<char *> argv = {const_cast<char *>("javino-emulator")};
  for (std::string &argument : arguments) argv.push_back(&argument[0]);
  char error[256] = "";
  int result = options_parse(o, static_cast<int>(argv.size()), argv.data(), error, sizeof error);
  EXPECT_EQ(result == 0, error[0] == '\0');
  return error;
}

TEST(Options, all_are_read) {
  // Texts live as long as the arguments: look at numbers only.
  options o;
  ASSERT_EQ(parse(&o, {"s.json", "--duration", "2.5", "--speed", "max", "--seed", "7", "--set", "radio.range=1"}), "");
  EXPECT_EQ(o.duration_s, 2.5);
  EXPECT_EQ(o.speed, 0);
  EXPECT_EQ(o.seed, 7u);
  EXPECT_EQ(o.override_count, 1u);
}

TEST(Options, defaults) {
  options o;
  ASSERT_EQ(parse(&o, {"s.json"}), "");
  EXPECT_STREQ(o.directory, ".");
  EXPECT_EQ(o.duration_s, 0);
  EXPECT_EQ(o.speed, 1);
  EXPECT_EQ(o.seed, 1u);
  EXPECT_EQ(o.trace_path, nullptr);
}

TEST(Options, mistakes_get_a_line_that_helps) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> CASES = {
      {{}, "name a scenario file; try --help"},
      {{"a", "b"}, "scenario: expected one file, found \"b\""},
      {{"a", "--sped", "2"}, "unknown option --sped; did you mean --speed; try --help"},
      {{"a", "--speed"}, "--speed needs a value after it; try --help"},
      {{"a", "--speed", "fast"}, "--speed: expected a number above 0, or max, found \"fast\""},
      {{"a", "--speed", "-1"}, "--speed: expected a number above 0, or max, found \"-1\""},
      {{"a", "--speed", "nan"}, "--speed: expected a number above 0, or max, found \"nan\""},
      {{"a", "--duration", "0"}, "--duration: expected a number above 0, found \"0\""},
      {{"a", "--seed", "1.5"}, "--seed: expected a whole number, 0 or more, found \"1.5\""},
      {{"a", "--replay", "r", "--seed", "1"}, "--replay makes the run as it was recorded; leave out --seed"},
      {{"a", "--record", "x", "--replay", "r"}, "--replay makes the run as it was recorded; leave out --record"},
      {{"a", "--lockstep", "--replay", "r"}, "--replay makes the run as it was recorded; leave out --lockstep"},
      {{"a", "--lockstep", "--speed", "max"}, "--lockstep has neither speed nor record; leave out --speed"},
      {{"a", "--record", "x", "--lockstep"}, "--lockstep has neither speed nor record; leave out --record"},
      {{"a", "--lockstep", "--trace", "-"},
       "--trace: expected a file, as --lockstep answers on standard output, found \"-\""},
      {{"a", "--seed", "-1"}, "--seed: expected a whole number, 0 or more, found \"-1\""},
  };
  for (const auto &c : CASES) {
    options o;
    EXPECT_EQ(parse(&o, c.first), c.second);
  }
}
