// SPDX-License-Identifier: GPL-3.0-or-later
// Whole boards with real programs; all times are emulated.
#include "support.h"

#include <simavr/sim_avr.h>

#include <cmath>

TEST(Board, blinks_on_time_and_prints_to_the_trace) {
  Scratch scratch;
  Emulation run(scratch, R"({"boards":[{"name":"a","firmware":"@blink","watch":[{"pin":13,"name":"led"}]}]})");
  run.run_until(1.005);
  auto pins = run.events("a", "pin");
  ASSERT_EQ(pins.size(), 100u);
  for (size_t i = 0; i < pins.size(); i++) {
    EXPECT_NEAR(pins[i].t, 0.01 * static_cast<double>(i + 1), 0.0001);
    EXPECT_EQ(pins[i].number("level"), i % 2 == 0);
    EXPECT_EQ(pins[i].text("name"), "led");
  }
  auto lines = run.events("a", "uart");
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].text("line"), "blink");
  EXPECT_NEAR(lines[0].t, 0.0057, 0.001);  // six bytes at 9600 baud
}

TEST(Board, an_uno_blinks_beside_a_mega) {
  Scratch scratch;
  Emulation run(scratch, R"({"boards":[
        {"name":"a","firmware":"@blink","watch":[{"pin":13,"name":"led"}]},
        {"name":"u","model":"uno","firmware":"@uno_blink","watch":[{"pin":13,"name":"led"}]}]})");
  run.run_until(0.505);
  auto pins = run.events("u", "pin");
  ASSERT_EQ(pins.size(), 50u);
  for (size_t i = 0; i < pins.size(); i++) EXPECT_NEAR(pins[i].t, 0.01 * static_cast<double>(i + 1), 0.0001);
  EXPECT_EQ(run.events("a", "pin").size(), 50u);
  ASSERT_EQ(run.events("u", "uart").size(), 1u);
}

TEST(Board, a_pro_mini_blinks_on_time_at_half_the_clock) {
  Scratch scratch;
  Emulation run(scratch, R"({"boards":[
        {"name":"a","firmware":"@blink","watch":[{"pin":13,"name":"led"}]},
        {"name":"p","model":"promini","firmware":"@promini_blink","watch":[{"pin":13,"name":"led"}]}]})");
  run.run_until(0.505);
  auto pins = run.events("p", "pin");
  ASSERT_EQ(pins.size(), 50u);
  for (size_t i = 0; i < pins.size(); i++) EXPECT_NEAR(pins[i].t, 0.01 * static_cast<double>(i + 1), 0.0001);
  EXPECT_EQ(run.events("a", "pin").size(), 50u);
  auto lines = run.events("p", "uart");
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_NEAR(lines[0].t, 0.0057, 0.001);  // six bytes at 9600 baud
}

TEST(Board, a_pull_up_works_after_a_reset_too) {
  Scratch scratch;
  Emulation run(scratch, R"({"boards":[{"name":"a","firmware":"@pull_up"}],
        "faults":[{"t":0.1,"board":"a","do":"reset"}]})");
  run.run_until(0.2);
  auto lines = run.events("a", "uart");
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].text("line"), "high");
  EXPECT_EQ(lines[1].text("line"), "high");
}

TEST(Board, boards_keep_in_step) {
  Scratch scratch;
  Emulation run(scratch, R"({"boards":[
        {"name":"a","firmware":"@blink","watch":[{"pin":13,"name":"led"}]},
        {"name":"b","firmware":"@sensors","sensors":[{"type":"hc-sr04","trigger":22,"echo":2,"distance":[[0,50]]}]},
        {"name":"c","firmware":"@blink","watch":[{"pin":13,"name":"led"}]},
        {"name":"p","model":"promini","firmware":"@promini_blink"},
        {"name":"fast","firmware":"@blink","clockError":5000},
        {"name":"slow","model":"promini","firmware":"@promini_blink","clockError":-5000}]})");
  for (int ms = 1; ms <= 300; ms++) {
    run.run_until(ms / 1000.0);
    for (int i = 0; i < 6; i++) {
      cycles_t now = board_now(&run.e.nodes[i].arduino);
      EXPECT_GE(now, run.e.now);
      EXPECT_LT(now, run.e.now + 10 * CYCLES_PER_US);
    }
  }
  auto a = run.events("a", "pin");
  auto c = run.events("c", "pin");
  ASSERT_EQ(a.size(), c.size());
  for (size_t i = 0; i < a.size(); i++) EXPECT_EQ(a[i].t, c[i].t);
}

TEST(Board, a_clock_error_makes_all_of_a_board_so_much_faster_or_slower) {
  Scratch scratch;
  Emulation run(scratch, R"({"boards":[
        {"name":"exact","firmware":"@blink","watch":[{"pin":13,"name":"led"}]},
        {"name":"fast","clockError":5000,"firmware":"@blink","watch":[{"pin":13,"name":"led"}]},
        {"name":"slow","clockError":-50000,"model":"promini","firmware":"@promini_blink",
         "watch":[{"pin":13,"name":"led"}]}]})");
  run.run_until(2.2);
  auto exact = run.events("exact", "pin"), fast = run.events("fast", "pin");
  ASSERT_GT(fast.size(), 200u);
  for (size_t i = 0; i < 200; i++) EXPECT_NEAR(fast[i].t * 1.005, exact[i].t, 2e-6);
  auto slow = run.events("slow", "pin");
  ASSERT_GE(slow.size(), 200u);
  EXPECT_NEAR(slow[199].t * 0.95, 2, 0.0002);
  // The six bytes of the UART, too.
  EXPECT_NEAR(run.events("fast", "uart").at(0).t * 1.005, run.events("exact", "uart").at(0).t, 2e-6);
}

TEST(Board, the_common_clock_and_a_boards_own_agree_to_the_cycle_for_years) {
  for (int ppm : {-50000, -3333, -1, 1, 40, 5000, 50000}) {
    Scratch scratch;
    Emulation run(scratch, R"({"boards":[{"name":"a","firmware":"@halt","clockError":)" + std::to_string(ppm) + "}]}");
    board *b = &run.e.nodes[0].arduino;
    board_power_off(b, &run.e.nodes[0].noise);  // its time goes on, and nothing has to be run for that
    for (cycles_t at : {seconds_to_cycles(0.1), seconds_to_cycles(1), seconds_to_cycles(1e8)}) {
      ASSERT_EQ(board_run(b, at), 0);
      // The first of the board's cycles that is not before that time.
      EXPECT_GE(board_now(b), at);
      EXPECT_LE(board_now(b), at + 1);
      auto cycles = static_cast<long double>(at) * (1000000 + ppm) / 1000000;
      EXPECT_EQ(b->avr->cycle, static_cast<cycles_t>(std::ceil(cycles))) << ppm;
    }
  }
}

TEST(Board, a_sleeping_board_is_not_run_in_between) {
  Scratch scratch;
  Emulation run(scratch, R"({"boards":[{"name":"a","firmware":"@blink"}]})");
  run.run_until(0.0151);
  EXPECT_GE(board_next_event(&run.e.nodes[0].arduino), seconds_to_cycles(0.02));
}

TEST(Board, a_crash_names_board_and_place) {
  Scratch scratch;
  Emulation run(scratch, R"({"boards":[{"name":"bad","firmware":"@crash"}]})");
  EXPECT_EQ(emulation_run(&run.e, seconds_to_cycles(1)), -1);
  EXPECT_EQ(std::string(run.e.error).find("board bad: its program crashed at pc 0x"), 0u) << run.e.error;
}

TEST(Board, the_watchdog_resets_it) {
  Scratch scratch;
  Emulation run(scratch, R"({"boards":[{"name":"dog","firmware":"@watchdog"}]})");
  run.run_until(0.1);
  auto resets = run.events("dog", "reset");
  ASSERT_GE(resets.size(), 5u);
  EXPECT_EQ(resets[0].text("why"), "power");
  EXPECT_EQ(resets[1].text("why"), "watchdog");
  EXPECT_NEAR(resets[1].t, 0.016, 0.002);
}

TEST(Board, asleep_with_interrupts_off_it_stays_so_until_reset) {
  Scratch scratch;
  Emulation run(scratch,
                R"({"boards":[{"name":"a","firmware":"@halt","port":"p","watch":[{"pin":22,"name":"woke"}]}]})");
  run.run_until(0.5);
  EXPECT_TRUE(run.events("a", "pin").empty());
  EXPECT_TRUE(run.e.nodes[0].arduino.halted);
  board_reset(&run.e.nodes[0].arduino);
  EXPECT_FALSE(run.e.nodes[0].arduino.halted);
}

TEST(Board, firmware_for_something_else_is_refused) {
  Scratch scratch;
  board b;
  char error[512];
  std::string text = scratch.write("text.elf", "no program");
  EXPECT_EQ(board_init(&b, &MEGA, text.c_str(), {}, error, sizeof error), -1);
  EXPECT_EQ(error, text + " is neither ELF nor Intel HEX; expected the .elf or .hex of a build for an AVR");
  board_release(&b);
  EXPECT_EQ(board_init(&b, &MEGA, EMULATOR, {}, error, sizeof error), -1);
  EXPECT_NE(std::string(error).find("is built for another processor"), std::string::npos) << error;
  board_release(&b);
  EXPECT_EQ(board_init(&b, &UNO, PROGRAMS_DIR "/blink.elf", {}, error, sizeof error), -1);
  EXPECT_STREQ(error, PROGRAMS_DIR
               "/blink.elf is built for another AVR; expected one for the ATmega328P "
               "(-mmcu=atmega328p), the model \"uno\"");
  board_release(&b);
}

// The boot loader of Debian's arduino-core-avr, which the sketches are built with.
static const std::string BOOT_LOADER =
    "/usr/share/arduino/hardware/arduino/avr/bootloaders/stk500v2/stk500boot_v2_mega2560.hex";

TEST(Board, a_boot_loader_waits_for_a_second_and_then_starts_the_program) {
  Scratch scratch;
  Emulation run(scratch, R"({"boards":[{"name":"a","firmware":"@boot_count","bootLoader":")" + BOOT_LOADER + "\"}]}");
  run.run_until(1.5);
  board_reset(&run.e.nodes[0].arduino);
  run.run_until(3);
  auto lines = run.events("a", "uart");
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[1].text("line"), "1");  // the second start: the first one finds 0xFF and prints 0
  EXPECT_NEAR(lines[0].t, 0.83, 0.1);
  EXPECT_NEAR(lines[1].t, 1.5 + 0.83, 0.1);
}

TEST(Board, what_is_no_boot_loader_is_refused) {
  Scratch scratch;
  board b;
  char error[512];
  // A program of one byte at address 0.
  std::string program = scratch.write("program.hex", ":0100000000FF\n:00000001FF\n");
  ASSERT_EQ(board_init(&b, &MEGA, PROGRAMS_DIR "/blink.elf", {}, error, sizeof error), 0);
  EXPECT_EQ(firmware_add_boot_loader(b.avr, &MEGA, program.c_str(), error, sizeof error), -1);
  EXPECT_EQ(error, program +
                       " holds no boot loader for the ATmega2560; expected Intel HEX in the last 8192 bytes of "
                       "its flash");
  board_release(&b);
}

TEST(Board, the_timers_of_an_idle_arduino_let_it_sleep) {
  Scratch scratch;
  Emulation run(scratch, R"({"boards":[{"name":"a","firmware":"@arduino_idle"}]})");
  cycles_t longest = 0;
  for (int ms = 10; ms < 20; ms++) {
    run.run_until(ms / 1000.0);
    cycles_t sleep = board_next_event(&run.e.nodes[0].arduino) - run.e.now;
    longest = sleep > longest ? sleep : longest;
  }
  EXPECT_GT(longest, CYCLES_PER_MS / 4);  // and not the 64 cycles of one timer clock
}

TEST(Board, tells_the_duty_of_a_pin_until_the_program_has_it_again) {
  Scratch scratch;
  Emulation run(scratch, R"({"boards":[{"name":"car","firmware":"@pwm",
      "watch":[{"pin":11,"name":"motor"},{"pin":4,"name":"lamp"}]}]})");
  run.run_until(0.1);
  std::vector<std::string> duties;
  for (const Event &event : run.events("car", "pwm"))
    duties.push_back(event.text("name") + " " + std::to_string(std::lround(event.real("duty") * 100)));
  EXPECT_EQ(duties, (std::vector<std::string>{"motor 0", "motor 20", "lamp 0", "lamp 80", "lamp 20"}));
  auto levels = run.events("car", "pin");
  ASSERT_EQ(levels.size(), 2u);
  EXPECT_EQ(levels[0].text("name") + levels[1].text("name"), "motormotor");
  EXPECT_EQ(levels[0].number("level"), 0);
  EXPECT_EQ(levels[1].number("level"), 1);
  EXPECT_EQ(run.command(R"({"do":"reset","board":"car"})"), "");
  auto after = run.events("car", "pin");
  ASSERT_EQ(after.size(), 4u);
  EXPECT_EQ(after[3].text("name"), "lamp");
  EXPECT_EQ(after[3].number("level"), 0);
}
