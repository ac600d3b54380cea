// SPDX-License-Identifier: GPL-3.0-or-later
#include "support.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

static const char COUNTER[] = R"({"boards":[{"name":"a","firmware":"@boot_count","eeprom":"eeprom/a.bin"}]})";

static std::string last_line(Emulation &run) {
  auto lines = run.events("a", "uart");
  return lines.empty() ? "" : lines.back().text("line");
}

TEST(Eeprom, survives_from_run_to_run) {
  Scratch scratch;
  for (char count : {'0', '1', '2'}) {
    Emulation run(scratch, COUNTER);
    run.run_until(0.01);
    EXPECT_EQ(last_line(run), std::string(1, count));
  }
  EXPECT_EQ(read_text(scratch.path("eeprom/a.bin")).size(), 4096u);
}

TEST(Eeprom, of_an_uno_survives_from_run_to_run) {
  Scratch scratch;
  for (char count : {'0', '1', '2'}) {
    Emulation run(scratch, R"({"boards":[{"name":"a","model":"uno","firmware":"@uno_boot_count","eeprom":"a.bin"}]})");
    run.run_until(0.01);
    EXPECT_EQ(last_line(run), std::string(1, count));
  }
  EXPECT_EQ(read_text(scratch.path("a.bin")).size(), 1024u);
}

TEST(Eeprom, survives_a_reset) {
  Scratch scratch;
  std::string json = COUNTER;
  json.replace(json.rfind("}"), 1, R"(,"faults":[{"t":0.02,"board":"a","do":"reset"}]})");
  Emulation run(scratch, json);
  run.run_until(0.04);
  EXPECT_EQ(last_line(run), "1");
}

TEST(Eeprom, is_in_the_file_soon_after_it_was_written) {
  Scratch scratch;
  Emulation run(scratch, COUNTER);
  run.run_until(0.11);
  EXPECT_EQ(read_text(scratch.path("eeprom/a.bin"))[0], '\0');  // 0xFF + 1, the run still under way
}

TEST(Eeprom, is_forgotten_without_a_file) {
  Scratch scratch;
  for (int i = 0; i < 2; i++) {
    Emulation run(scratch, R"({"boards":[{"name":"a","firmware":"@boot_count"}]})");
    run.run_until(0.01);
    EXPECT_EQ(last_line(run), "0");
  }
}

TEST(Eeprom, a_file_of_the_wrong_size_is_refused_and_left_alone) {
  for (size_t size : {0, 1, 4095, 4097}) {
    Scratch scratch;
    ASSERT_EQ(scratch.write("a.bin", std::string(size, 'x')), scratch.path("a.bin"));
    try {
      Emulation run(scratch, R"({"boards":[{"name":"a","firmware":"@boot_count","eeprom":"a.bin"}]})");
      FAIL() << size;
    } catch (const std::runtime_error &e) {
      EXPECT_EQ(e.what(),
                "EEPROM file " + scratch.path("a.bin") + ": expected exactly 4096 bytes; remove it to start anew");
    }
    EXPECT_EQ(read_text(scratch.path("a.bin")), std::string(size, 'x'));
  }
}

TEST(Eeprom, of_two_boards_by_two_names_is_refused) {
  Scratch scratch;
  try {
    Emulation run(scratch, R"({"boards":[{"name":"a","firmware":"@boot_count","eeprom":"a.bin"},
                                             {"name":"b","firmware":"@boot_count","eeprom":"./a.bin"}]})");
    FAIL();
  } catch (const std::runtime_error &e) {
    EXPECT_NE(std::string(e.what()).find("another emulator or board uses it"), std::string::npos) << e.what();
  }
}

TEST(Eeprom, is_still_locked_after_it_was_saved) {
  Scratch scratch;
  Emulation run(scratch, COUNTER);
  run.run_until(0.2);
  EXPECT_EQ(read_text(scratch.path("eeprom/a.bin"))[0], '\0');
  int other = open(scratch.path("eeprom/a.bin").c_str(), O_RDWR);
  EXPECT_NE(flock(other, LOCK_EX | LOCK_NB), 0);
  close(other);
}

TEST(Eeprom, takes_the_time_of_a_real_one) {
  Scratch scratch;
  Emulation run(scratch, R"({"boards":[{"name":"a","firmware":"@eeprom_times"}]})");
  run.run_until(0.1);
  static const struct {
    const char *name;
    int us, value;
  } CASES[] = {
      {"write", 3400, 0x0F},      {"write-only", 1800, 0x0C},  // clears bits only
      {"erase-only", 1800, 0xFF}, {"update", 0, 0xFF},         // the same value: nothing is written
      {"hasty", 3400, 0x11},                                   // the second write comes during the first
      {"unarmed", 0, 0x11},       {"late", 0, 0x11},          {"interrupt", 3 * 3400, 0x11},
  };
  auto lines = run.events("a", "uart");
  ASSERT_EQ(lines.size(), std::size(CASES) + 1);
  for (size_t i = 0; i < std::size(CASES); i++) {
    char name[32];
    int us = -1, value = -1;
    ASSERT_EQ(sscanf(lines[i].text("line").c_str(), "%31s %d %x", name, &us, &value), 3);
    EXPECT_STREQ(name, CASES[i].name);
    EXPECT_NEAR(us, CASES[i].us, 40) << name;
    EXPECT_EQ(value, CASES[i].value) << name;
  }
  EXPECT_EQ(lines.back().text("line"), "01 02 03");
  run.close();
  EXPECT_EQ(run.events("counters")[0].number("eepromWrites"), 4 + 3);
}

TEST(Eeprom, a_reset_does_not_break_off_a_write) {
  Scratch scratch;
  Emulation run(scratch, R"({"boards":[{"name":"a","firmware":"@eeprom_writer","eeprom":"a.bin"}],
        "faults":[{"t":0.001,"board":"a","do":"reset","after":{"pin":13}}]})");
  run.run_until(0.1);
  EXPECT_EQ(last_line(run), "kept 256 busy");
  EXPECT_EQ(read_text(scratch.path("a.bin"))[0], '\x55');
}
