// SPDX-License-Identifier: GPL-3.0-or-later
// Trace points that a board tells, and the bytes that it writes to its EEPROM before.
#include "support.h"

namespace {

struct PointLog : testing::TestWithParam<const char *> {
  PointLog() : run(scratch, std::string(R"({"boards":[{"name":"a",)") + GetParam() + "}]}") { run.run_until(0.2); }
  std::vector<Event> points() { return run.events("a", "point"); }
  std::vector<Event> bytes() { return run.events("a", "eeprom"); }

  Scratch scratch;
  Emulation run;
};

}  // namespace

INSTANTIATE_TEST_SUITE_P(Chips, PointLog,
                         testing::Values(R"("firmware":"@points")", R"("model":"uno","firmware":"@uno_points")"));

TEST_P(PointLog, a_point_has_its_name_and_its_operands_by_their_names) {
  auto told = points();
  ASSERT_EQ(told.size(), 6u);  // and not one of number 255, nor what is as before: a run()'s air, a turn
  EXPECT_EQ(told[0].text("name"), "EPOCH_STORED");
  EXPECT_EQ(told[0].number("low"), 7);
  EXPECT_EQ(json_object_size(told[0].fields), 5u);  // no other operand, and no run() before
  EXPECT_EQ(told[4].text("name"), "TURN");
  EXPECT_EQ(told[4].number("number"), 3);
  EXPECT_EQ(told[5].text("name"), "FLOOR_STORED");
  EXPECT_EQ(told[5].number("key"), 4);
  EXPECT_EQ(told[5].number("place"), 9);
}

TEST_P(PointLog, a_run_is_told_that_finds_the_air_changed_or_comes_late) {
  auto told = points();
  ASSERT_EQ(told.size(), 6u);
  EXPECT_EQ(told[1].text("name"), "QUIET");
  EXPECT_EQ(told[1].real("gap"), 0);
  EXPECT_EQ(told[2].text("name"), "BUSY");
  EXPECT_NEAR(told[2].t - told[1].t, 0.005, 0.0001);
  EXPECT_NEAR(told[2].real("gap"), 0.001, 0.0001);
  EXPECT_EQ(told[3].text("name"), "BUSY");
  EXPECT_NEAR(told[3].real("gap"), 0.005, 0.0001);
}

TEST_P(PointLog, a_point_tells_when_the_run_began_that_it_lies_in) {
  auto told = points();
  ASSERT_EQ(told.size(), 6u);
  EXPECT_NEAR(told[4].real("run"), told[3].t, 0.000002);
  EXPECT_EQ(told[4].real("gap"), told[3].real("gap"));
}

TEST(PointLogPackets, a_point_names_the_packet_that_has_come_last_but_no_run_and_no_turn) {
  Scratch scratch;
  Emulation run(scratch, R"({"boards":[{"name":"a","firmware":"@points"}]})");
  run.e.listener.stations[0].heard = 12;
  run.run_until(0.2);
  for (const Event &told : run.events("a", "point")) {
    bool named = told.text("name") == "EPOCH_STORED" || told.text("name") == "FLOOR_STORED";
    EXPECT_EQ(told.number("packet"), named ? 12 : 0) << told.text("name");
  }
}

TEST_P(PointLog, bytes_of_the_eeprom_are_told_before_the_point_behind_them) {
  auto told = bytes();
  ASSERT_GE(told.size(), 2u);
  EXPECT_EQ(told[0].number("at"), 10);
  EXPECT_EQ(told[0].text("hex"), "0a0b0c0d0e0f");
  std::string text = run.trace_text();
  EXPECT_LT(text.find("\"eeprom\""), text.find("EPOCH_STORED"));
}

TEST_P(PointLog, of_many_bytes_beside_each_other_only_the_first_are_told) {
  auto told = bytes();
  ASSERT_EQ(told.size(), 2u);  // the last byte has no point behind it, nor the end yet
  EXPECT_EQ(told[1].number("at"), 100);
  EXPECT_EQ(told[1].number("length"), 30);
  EXPECT_EQ(told[1].text("hex"), "6465666768696a6b");
  run.close();
  EXPECT_EQ(bytes().size(), 3u);
}

TEST(PointLogBytes, bytes_written_downwards_are_told_as_they_lie) {
  Scratch scratch;
  trace out = {fopen(scratch.path("trace").c_str(), "w"), false};
  point_log log;
  const uint64_t heard = 0;
  point_log_init(&log, &out, "a", &heard, 1);
  for (uint16_t at : {12, 11, 10, 13, 10}) point_log_eeprom(&log, at, (uint8_t)at, 0);
  point_log_reset(&log);  // the last byte may be part of what is longer
  fclose(out.file);
  EXPECT_EQ(read_text(scratch.path("trace")),
            "{\"t\":0.000000,\"board\":\"a\",\"event\":\"eeprom\",\"at\":10,\"length\":4,\"hex\":\"0a0b0c0d\"}\n");
}
