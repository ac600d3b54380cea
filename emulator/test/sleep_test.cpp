// SPDX-License-Identifier: GPL-3.0-or-later
// The events that wake a sketch from each sleep mode, and the clocks that go on meanwhile.
#include "support.h"

#include <fcntl.h>
#include <unistd.h>

static const double WATCHDOG = 0.128;
static const double CRYSTAL = 16384.0 / 16e6;  // the oscillator's start

// Runs a sketch, sleeper.ino, for some seconds; `more` are keys of its board.
static std::string sleeper(const std::string &program, const std::string &model, const std::string &more = "") {
  return R"({"boards":[{"name":"a","model":")" + model + R"(","firmware":"@)" + program + R"(","watch":[
      {"pin":13,"name":"awake"},{"pin":12,"name":"time"},{"pin":10,"name":"heard"},{"pin":9,"name":"woken"}])" +
         more + "}]}";
}

static std::vector<double> times(Emulation &run, const std::string &name) {
  std::vector<double> found;
  for (const Event &pin : run.events("a", "pin"))
    if (pin.text("name") == name) found.push_back(pin.t);
  return found;
}

// The seconds from the second waking to the third.
static double period(const std::string &program, const std::string &model = "mega") {
  Scratch scratch;
  Emulation run(scratch, sleeper(program, model));
  run.run_until(0.6);
  std::vector<double> awake = times(run, "awake");
  return awake.size() < 3 ? 0 : awake[2] - awake[1];
}

TEST(Sleep, in_idle_ends_with_the_next_interrupt_of_any_timer) { EXPECT_NEAR(0.001024, period("sleep_IDLE"), 0.0001); }

TEST(Sleep, with_stopped_clocks_lasts_until_the_watchdog_s_interrupt) {
  for (const char *mode : {"ADC", "PWR_DOWN", "PWR_SAVE", "STANDBY", "EXT_STANDBY"})
    EXPECT_NEAR(WATCHDOG, period(std::string("sleep_") + mode), 0.0001) << mode;
  EXPECT_NEAR(WATCHDOG, period("uno_sleep", "uno"), 0.0001);
  EXPECT_NEAR(WATCHDOG, period("promini_sleep", "promini"), 0.0001);
}

TEST(Sleep, stops_the_timers_of_a_sketch_in_all_modes_but_idle) {
  for (const char *mode : {"ADC", "PWR_DOWN", "PWR_SAVE", "STANDBY", "EXT_STANDBY"}) {
    Scratch scratch;
    Emulation run(scratch, sleeper(std::string("sleep_") + mode, "mega"));
    run.run_until(0.6);
    EXPECT_TRUE(times(run, "time").empty()) << mode;
  }
}

TEST(Sleep, for_less_noise_begins_a_conversion_which_ends_it) {
  EXPECT_NEAR(13 * 128 / 16e6, period("sleep_conversion"), 0.0001);
}

TEST(Sleep, with_stopped_clocks_ends_with_no_conversion) {
  EXPECT_NEAR(WATCHDOG, period("sleep_no_conversion"), 0.0001);
}

TEST(Sleep, that_is_not_enabled_is_none) { EXPECT_LT(period("sleep_disabled"), 0.0001); }

// When the interrupt of a pin came that was low from 0.3 s to 0.3015 s; 0 if it never did.
static double woken(const std::string &program, const std::string &model, int pin) {
  Scratch scratch;
  Emulation run(scratch, sleeper(program, model,
                                 R"(,"sensors":[{"type":"digital","pin":)" + std::to_string(pin) +
                                     R"(,"level":[[0,1],[0.3,0],[0.3015,1]]}])"));
  run.run_until(0.5);
  std::vector<double> found = times(run, "woken");
  return found.empty() ? 0 : found[0];
}

TEST(Sleep, with_stopped_clocks_ends_with_a_pin_s_level) {
  EXPECT_NEAR(0.3 + CRYSTAL, woken("sleep_until_level", "mega", 2), 0.0001);
  EXPECT_NEAR(0.3 + CRYSTAL, woken("uno_sleep_until_level", "uno", 2), 0.0001);
}

TEST(Sleep, with_stopped_clocks_ends_with_an_edge_only_at_pins_that_need_no_clock_to_see_it) {
  EXPECT_NEAR(0.3 + CRYSTAL, woken("sleep_until_edge", "mega", 21), 0.0001);
  EXPECT_EQ(0, woken("sleep_until_edge", "mega", 2));
  EXPECT_EQ(0, woken("uno_sleep_until_edge", "uno", 2));
  EXPECT_NEAR(0.3, woken("uno_idle_until_edge", "uno", 2), 0.0001);
}

// How many bytes the sketch has got of two from the host.
static size_t heard(const std::string &program) {
  Scratch scratch;
  Emulation run(scratch, sleeper(program, "mega", R"(,"port":"a","resetOnOpen":false)"));
  run.run_until(0.01);
  int host = open(scratch.path("a").c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK);
  EXPECT_EQ(2, write(host, "xy", 2));
  run.run_while_waiting(0.3, [] { return false; });
  close(host);
  return times(run, "heard").size();
}

TEST(Sleep, with_stopped_clocks_loses_bytes_from_the_host) {
  EXPECT_EQ(2u, heard("sleep_IDLE"));
  EXPECT_EQ(0u, heard("sleep_PWR_DOWN"));
}

TEST(Sleep, ends_with_a_reset) {
  Scratch scratch;
  std::string json = sleeper("sleep_until_edge", "mega");
  json.insert(json.size() - 1, R"(,"faults":[{"t":0.2,"board":"a","do":"reset"}])");
  Emulation run(scratch, json);
  run.run_until(0.3);
  EXPECT_EQ(2u, run.events("a", "reset").size());
  EXPECT_GT(board_next_event(&run.e.nodes[0].arduino), seconds_to_cycles(0.3)) << "it sleeps again";
}
