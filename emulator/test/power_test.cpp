// SPDX-License-Identifier: GPL-3.0-or-later
// Power cuts, and what is left after them.
#include "support.h"

#include <fcntl.h>
#include <poll.h>
#include <set>
#include <unistd.h>

// A board whose program writes 0x55 to its EEPROM, of zeros so far, byte after byte.
static std::string eepromWriter(const Scratch &scratch, const std::string &faults) {
  scratch.write("a.bin", std::string(4096, '\0'));
  return R"({"boards":[{"name":"a","firmware":"@eeprom_writer","eeprom":"a.bin","watch":[{"pin":13,"name":"writes"}]}],
        "faults":[)" +
         faults + "]}";
}

static int kept(const Event &line) {
  int count = -1;
  EXPECT_EQ(sscanf(line.text("line").c_str(), "kept %d", &count), 1) << line.text("line");
  return count;
}

TEST(Power, a_cut_lasts_and_ends_in_a_start) {
  Scratch scratch;
  Emulation run(scratch, eepromWriter(scratch, R"({"t":0.05,"board":"a","do":"power-cut","duration":0.2})"));
  run.run_until(0.3);
  auto resets = run.events("a", "reset");
  ASSERT_EQ(resets.size(), 2u);
  EXPECT_EQ(resets[1].text("why"), "power");
  EXPECT_NEAR(resets[1].t, 0.25, 0.0002);
  auto faults = run.events("a", "fault");
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].text("do"), "power-cut");
  EXPECT_NEAR(json_number_value(json_object_get(faults[0].fields, "until")), 0.25, 0.0002);
  for (const Event &pin : run.events("a", "pin")) EXPECT_FALSE(pin.t > 0.0502 && pin.t < 0.25) << pin.t;
}

TEST(Power, ram_holds_anything_after_a_cut_and_all_after_a_reset) {
  Scratch scratch;
  Emulation run(scratch, eepromWriter(scratch, R"({"t":0.05,"board":"a","do":"power-cut","duration":0.01},
                                              {"t":0.1,"board":"a","do":"reset"})"));
  run.run_until(0.15);
  auto lines = run.events("a", "uart");
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_LT(kept(lines[0]), 10);  // one in 256, by chance
  EXPECT_LT(kept(lines[1]), 10);
  EXPECT_EQ(kept(lines[2]), 256);
}

TEST(Power, pins_fall_at_a_cut) {
  Scratch scratch;
  Emulation run(scratch,
                eepromWriter(scratch, R"({"t":0.001,"board":"a","do":"power-cut","duration":1,"after":{"pin":13}})"));
  run.run_until(0.5);
  auto pins = run.events("a", "pin");
  ASSERT_EQ(pins.size(), 2u);
  EXPECT_EQ(pins[1].number("level"), 0);
  EXPECT_NEAR(pins[1].t - pins[0].t, 0.001, 0.0002);
  EXPECT_FALSE(board_output(&run.e.nodes[0].arduino, 13));
}

TEST(Power, a_sleeping_board_is_cut_and_starts_in_time) {
  Scratch scratch;
  Emulation run(scratch, R"({"boards":[{"name":"a","firmware":"@blink"}],
        "faults":[{"t":0.025,"board":"a","do":"power-cut","duration":5}]})");
  run.run_until(0.03);
  EXPECT_GE(board_next_event(&run.e.nodes[0].arduino), seconds_to_cycles(5.025));  // nothing to run in between
  run.run_until(5.1);
  EXPECT_NEAR(run.events("a", "reset").at(1).t, 5.025, 0.0002);
}

TEST(Power, a_transmission_breaks_off) {
  Scratch scratch;
  Emulation run(scratch, R"({"boards":[
        {"name":"sender","firmware":"@rf_send"},
        {"name":"mirror","firmware":"@rf_mirror","watch":[{"pin":5,"name":"rx"}]}],
        "faults":[{"t":0.1,"board":"sender","do":"power-cut","duration":1}]})");
  run.run_until(0.5);
  EXPECT_TRUE(run.events("rf-tx").empty());
  auto rx = run.events("mirror", "pin");
  ASSERT_FALSE(rx.empty());
  EXPECT_EQ(rx.back().number("level"), 0);
  EXPECT_LT(rx.back().t, 0.1003);
  run.close();
  EXPECT_EQ(run.events("sender", "counters").at(0).number("radioUndecodable"), 1);
}

TEST(Power, the_port_goes_and_comes_with_it) {
  Scratch scratch;
  Emulation run(scratch, R"({"boards":[{"name":"a","firmware":"@uart_echo","port":"a"}],
        "faults":[{"t":0.05,"board":"a","do":"power-cut","duration":0.05}]})");
  int host = open(scratch.path("a").c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK);
  struct pollfd state = {host, POLLIN, 0};
  EXPECT_TRUE(run.run_while_waiting(0.2, [&] { return poll(&state, 1, 0) == 1 && (state.revents & POLLHUP); }));
  EXPECT_NEAR(cycles_to_seconds(run.e.now), 0.05, 0.002);
  EXPECT_FALSE(exists(scratch.path("a")));
  close(host);
  EXPECT_TRUE(run.run_while_waiting(0.2, [&] { return exists(scratch.path("a")); }));
  EXPECT_NEAR(cycles_to_seconds(run.e.now), 0.1, 0.002);
  std::vector<std::string> states;
  for (const Event &event : run.events("a", "port")) states.push_back(event.text("state"));
  EXPECT_EQ(states, (std::vector<std::string>{"open", "unplugged", "plugged"}));
}

TEST(Power, a_port_plugged_or_unplugged_meanwhile_is_so_afterwards) {
  Scratch scratch;
  Emulation run(scratch, R"({"boards":[
        {"name":"a","firmware":"@uart_echo","port":"a"}, {"name":"b","firmware":"@uart_echo","port":"b"}],
        "faults":[{"t":0.01,"board":"b","do":"unplug"},
                  {"t":0.05,"board":"a","do":"power-cut","duration":0.05},
                  {"t":0.05,"board":"b","do":"power-cut","duration":0.05},
                  {"t":0.06,"board":"a","do":"unplug"}, {"t":0.06,"board":"b","do":"plug"}]})");
  run.run_until(0.09);
  EXPECT_FALSE(exists(scratch.path("a")));
  EXPECT_FALSE(exists(scratch.path("b")));
  run.run_until(0.2);
  EXPECT_FALSE(exists(scratch.path("a")));
  EXPECT_TRUE(exists(scratch.path("b")));
}

TEST(Power, cuts_that_overlap_end_with_the_last) {
  Scratch scratch;
  Emulation run(scratch, eepromWriter(scratch, R"({"t":0.05,"board":"a","do":"power-cut","duration":0.1},
                                              {"t":0.06,"board":"a","do":"power-cut","duration":0.01},
                                              {"t":0.07,"board":"a","do":"reset"},
                                              {"t":0.08,"board":"a","do":"power-cut","duration":0.1})"));
  run.run_until(0.3);
  auto resets = run.events("a", "reset");
  ASSERT_EQ(resets.size(), 2u);
  EXPECT_NEAR(resets[1].t, 0.18, 0.0002);
  run.close();
  EXPECT_EQ(run.events("counters")[0].number("powerCuts"), 3);
  EXPECT_EQ(run.events("counters")[0].number("resets"), 0);
}

namespace {

struct Torn {
  int byte;
  std::string trace;
};

}  // namespace

// Cuts the power at the third write after 20 ms; the writes begin every 8.4 ms.
static Torn torn_write(uint64_t seed) {
  Scratch scratch;
  Emulation run(
      scratch, eepromWriter(scratch, R"({"t":0.02,"board":"a","do":"power-cut","duration":1,"eepromWrites":3})"), seed);
  run.run_until(0.2);
  run.close();
  std::string bytes = read_text(scratch.path("a.bin"));
  EXPECT_EQ(bytes.substr(0, 5), std::string(5, '\x55'));
  EXPECT_EQ(bytes.substr(6), std::string(4090, '\0'));
  auto faults = run.events("a", "fault");
  EXPECT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults.at(0).number("torn"), 5);
  EXPECT_EQ(faults.at(0).t, run.events("a", "pin").back().t);  // at once: the pin falls with it
  EXPECT_EQ(run.events("counters").at(0).number("eepromWrites"), 6);
  EXPECT_EQ(run.events("counters").at(0).number("faultsPending"), 0);
  return {static_cast<unsigned char>(bytes[5]), run.trace_text()};
}

TEST(Power, the_nth_eeprom_write_is_torn) {
  std::set<int> seen;
  for (uint64_t seed = 1; seed <= 24; seed++) seen.insert(torn_write(seed).byte);
  EXPECT_TRUE(seen.count(0x00));  // not yet begun
  EXPECT_TRUE(seen.count(0xFF));  // erased
  EXPECT_GT(seen.size(), 6u);     // and all that lies between
}

TEST(Power, what_is_torn_repeats_by_seed) {
  Torn first = torn_write(7);
  Torn second = torn_write(7);
  EXPECT_EQ(first.byte, second.byte);
  EXPECT_EQ(first.trace, second.trace);
}

TEST(Power, a_cut_that_falls_into_a_write_tears_it_too) {
  Scratch scratch;
  Emulation run(scratch,
                eepromWriter(scratch, R"({"t":0.002,"board":"a","do":"power-cut","duration":1,"after":{"pin":13}})"));
  run.run_until(0.1);
  auto faults = run.events("a", "fault");
  ASSERT_EQ(faults.size(), 1u);
  ASSERT_NE(json_object_get(faults[0].fields, "torn"), nullptr);
  EXPECT_EQ(faults[0].number("torn"), 0);
}

TEST(Power, a_cut_between_writes_tears_nothing) {
  Scratch scratch;
  Emulation run(scratch, eepromWriter(scratch, R"({"t":0.002,"board":"a","do":"power-cut","duration":1,
                                               "after":{"pin":13,"level":0}})"));
  run.run_until(0.1);
  auto faults = run.events("a", "fault");
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(json_object_get(faults[0].fields, "torn"), nullptr);
  run.close();
  EXPECT_EQ(read_text(scratch.path("a.bin")).substr(0, 2), std::string("\x55\0", 2));
}

TEST(Power, two_cuts_at_the_same_write_come_one_after_the_other) {
  Scratch scratch;
  Emulation run(scratch, eepromWriter(scratch, R"({"t":0,"board":"a","do":"power-cut","duration":0.01,"eepromWrites":2},
                                              {"t":0,"board":"a","do":"power-cut","duration":0.01,"eepromWrites":2})"));
  run.run_until(0.1);
  auto faults = run.events("a", "fault");
  ASSERT_EQ(faults.size(), 2u);
  EXPECT_EQ(faults[0].number("torn"), 1);
  EXPECT_EQ(faults[1].number("torn"), 0);  // the first write after the start
}

TEST(Power, a_fault_that_does_not_come_is_counted) {
  Scratch scratch;
  Emulation run(scratch, eepromWriter(scratch, R"({"t":0,"board":"a","do":"power-cut","duration":1,"eepromWrites":1000},
                                              {"t":0,"board":"a","do":"reset","after":{"pin":22}},
                                              {"t":9,"board":"a","do":"reset"})"));
  run.run_until(0.1);
  run.close();
  EXPECT_TRUE(run.events("fault").empty());
  EXPECT_EQ(run.events("counters")[0].number("faultsPending"), 3);
  EXPECT_EQ(run.events("counters")[0].number("powerCuts"), 0);
}

TEST(Power, a_fault_after_a_pin_comes_so_long_after_its_first_change) {
  Scratch scratch;
  Emulation run(scratch, R"({"boards":[{"name":"a","firmware":"@blink","watch":[{"pin":13,"name":"led"}]}],
        "faults":[{"t":0.1,"board":"a","do":"reset","after":{"pin":13,"level":0}}]})");
  run.run_until(0.5);
  auto resets = run.events("a", "reset");
  ASSERT_EQ(resets.size(), 2u);
  EXPECT_EQ(resets[1].text("why"), "fault");
  EXPECT_NEAR(resets[1].t, 0.02 + 0.1, 0.0002);
}
