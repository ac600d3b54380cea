// SPDX-License-Identifier: GPL-3.0-or-later
// Two programs and the air between them, down to the pins.
#include "support.h"

static std::string two_boards(const std::string &radio = "", const std::string &more = "") {
  return R"({"radio":{)" + radio + R"(},"boards":[
        {"name":"sender","firmware":"@rf_send","position":[0,0],"watch":[{"pin":12,"name":"tx"}]},
        {"name":"mirror","firmware":"@rf_mirror","position":[30,40],"watch":[{"pin":5,"name":"rx"}]})" +
         more + "]}";
}

TEST(Radio, a_packet_is_seen_leaving_and_arriving) {
  Scratch scratch;
  Emulation run(scratch, two_boards());
  run.run_until(0.4);
  auto sent = run.events("sender", "rf-tx");
  ASSERT_EQ(sent.size(), 1u);
  EXPECT_EQ(sent[0].text("payload"), HELLO);
  EXPECT_EQ(sent[0].text("destination"), "////");
  EXPECT_EQ(sent[0].text("origin"), "CAFE");
  EXPECT_EQ(sent[0].text("kind"), "broadcast");
  EXPECT_FALSE(sent[0].flag("sealed"));
  EXPECT_EQ(sent[0].text("content"), "Hello!");
  EXPECT_EQ(sent[0].number("bits"), 84 + 12 * 16);
  auto received = run.events("mirror", "rf-rx");
  ASSERT_EQ(received.size(), 1u);
  EXPECT_EQ(received[0].text("from"), "sender");
  EXPECT_EQ(received[0].text("payload"), HELLO);
  EXPECT_EQ(sent[0].number("packet"), 1);
  EXPECT_EQ(received[0].number("packet"), 1);
  EXPECT_NEAR(received[0].t - sent[0].t, cycles_to_seconds(RF_DELAY), 0.000002);
  EXPECT_TRUE(run.events("rf-damaged").empty());
  EXPECT_TRUE(run.events("rf-collision").empty());
}

TEST(Radio, every_edge_arrives_at_the_pin_with_the_same_delay) {
  Scratch scratch;
  Emulation run(scratch, two_boards());
  run.run_until(0.4);
  auto tx = run.events("sender", "pin");
  auto rx = run.events("mirror", "pin");
  ASSERT_GT(tx.size(), 100u);
  ASSERT_EQ(tx.size(), rx.size());
  for (size_t i = 0; i < tx.size(); i++) {
    EXPECT_EQ(tx[i].number("level"), rx[i].number("level"));
    // The mirror's own loop takes a microsecond or so, and the emulator may add 4.
    EXPECT_NEAR(rx[i].t - tx[i].t, cycles_to_seconds(RF_DELAY), 0.000006);
  }
}

TEST(Radio, out_of_range_nothing_arrives) {
  Scratch scratch;
  Emulation run(scratch, two_boards(R"("range":49.9)"));
  run.run_until(0.4);
  EXPECT_EQ(run.events("rf-tx").size(), 1u);
  EXPECT_TRUE(run.events("rf-rx").empty());
  EXPECT_TRUE(run.events("rf-damaged").empty());
  EXPECT_TRUE(run.events("mirror", "pin").empty());
}

TEST(Radio, packets_that_overlap_damage_each_other) {
  Scratch scratch;
  Emulation run(scratch, two_boards("", R"(,{"name":"other","firmware":"@rf_send_later","position":[0,1]})"));
  run.run_until(0.4);
  EXPECT_EQ(run.events("rf-tx").size(), 2u);
  auto collisions = run.events("mirror", "rf-collision");
  ASSERT_EQ(collisions.size(), 1u);
  EXPECT_NEAR(collisions[0].t, 0.0706, 0.001);
  auto damaged = run.events("mirror", "rf-damaged");
  EXPECT_EQ(damaged.size(), 2u);
  auto sent = run.events("rf-tx");
  for (size_t i = 0; i < damaged.size(); i++) {
    EXPECT_EQ(damaged[i].number("packet"), static_cast<int>(i) + 1);
    EXPECT_EQ(sent[i].number("packet"), static_cast<int>(i) + 1);
    EXPECT_EQ(damaged[i].real("start"), sent[i].real("start"));
    EXPECT_EQ(damaged[i].real("end"), sent[i].real("end"));
    EXPECT_GT(damaged[i].t, damaged[i].real("end"));
  }
  EXPECT_TRUE(run.events("mirror", "rf-rx").empty());
  // The two hear each other well: each hears only the other.
  EXPECT_EQ(run.events("sender", "rf-rx").size(), 1u);
  EXPECT_EQ(run.events("other", "rf-rx").size(), 1u);
}

static std::string trace_with_errors(uint64_t seed) {
  Scratch scratch;
  Emulation run(scratch, two_boards(R"("bitErrorRate":0.003)"), seed);
  run.run_until(6);
  size_t received = run.events("rf-rx").size();
  size_t damaged = run.events("rf-damaged").size();
  EXPECT_EQ(received + damaged, run.events("rf-tx").size());
  // 276 bits at 0.003: 44 % get through, and some more as training may be damaged.
  EXPECT_GT(received, 2u);
  EXPECT_GT(damaged, 2u);
  return run.trace_text();
}

TEST(Radio, bit_errors_damage_some_packets_and_repeat_by_seed) {
  std::string first = trace_with_errors(1);
  EXPECT_EQ(first, trace_with_errors(1));
  EXPECT_NE(first, trace_with_errors(2));
}

TEST(Radio, a_jam_damages_what_is_sent_meanwhile) {
  Scratch scratch;
  std::string json = two_boards();
  json.replace(json.rfind("]}"), 2, R"(],"faults":[{"t":0.06,"do":"jam","duration":0.1}]})");
  Emulation run(scratch, json);
  run.run_until(0.8);
  EXPECT_EQ(run.events("rf-tx").size(), 2u);
  EXPECT_EQ(run.events("mirror", "rf-damaged").size(), 1u);
  EXPECT_EQ(run.events("mirror", "rf-rx").size(), 1u);
  EXPECT_GE(run.events("mirror", "rf-collision").size(), 1u);
  EXPECT_EQ(run.events("fault").size(), 1u);
}

TEST(Radio, counters_tell_it_all_at_the_end) {
  Scratch scratch;
  Emulation run(scratch, two_boards());
  run.run_until(0.8);
  run.close();
  auto counters = run.events("mirror", "counters");
  ASSERT_EQ(counters.size(), 1u);
  EXPECT_EQ(counters[0].number("radioReceived"), 2);
  EXPECT_EQ(run.events("sender", "counters").at(0).number("radioSent"), 2);
}
