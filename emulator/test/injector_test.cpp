// SPDX-License-Identifier: GPL-3.0-or-later
// Packets that commands put on the air without any board.
#include "support.h"

static const char HEARER[] = R"({"boards":[{"name":"near","firmware":"@blink","position":[0,0]},
    {"name":"far","firmware":"@blink","position":[150,0]}]})";

TEST(Injector, a_packet_is_heard_in_range_of_where_it_stands) {
  Scratch scratch;
  Emulation run(scratch, HEARER);
  EXPECT_EQ(run.command(R"({"do":"send","position":[-10,0],"payload":")" + HELLO + "\"}"), "");
  run.run_until(0.5);
  auto sent = run.events("rf-tx");
  ASSERT_EQ(sent.size(), 1u);
  EXPECT_EQ(sent[0].board, "injector");
  EXPECT_EQ(sent[0].text("payload"), HELLO);
  EXPECT_EQ(sent[0].text("content"), "Hello!");
  auto received = run.events("rf-rx");
  ASSERT_EQ(received.size(), 1u);
  EXPECT_EQ(received[0].board, "near");
  EXPECT_EQ(received[0].text("from"), "injector");
  EXPECT_EQ(received[0].text("payload"), HELLO);
}

TEST(Injector, a_bit_is_inverted_so_that_the_line_check_still_passes) {
  Scratch scratch;
  Emulation run(scratch, HEARER);
  EXPECT_EQ(run.command(R"({"do":"send","position":[0,0],"payload":"000000","flip":8})"), "");
  EXPECT_EQ(run.command(R"({"do":"send","position":[0,0],"payload":"FFffFF","flip":23})"), "");
  run.run_until(0.5);
  auto received = run.events("near", "rf-rx");
  ASSERT_EQ(received.size(), 2u);
  EXPECT_EQ(received[0].text("payload"), "000100");
  EXPECT_EQ(received[1].text("payload"), "ffff7f");
}

TEST(Injector, a_copy_tells_the_hops_behind_it_and_a_distance) {
  Scratch scratch;
  Emulation run(scratch, HEARER);
  EXPECT_EQ(run.command(R"({"do":"send","position":[0,0],"payload":"000000","hops":3})"), "");
  EXPECT_EQ(run.command(R"({"do":"send","position":[0,0],"payload":"000000","hops":0})"), "");
  EXPECT_EQ(run.command(R"({"do":"send","position":[0,0],"payload":"000000","hops":3,"distance":3})"), "");
  EXPECT_EQ(run.command(R"({"do":"send","position":[0,0],"payload":"000000","distance":0})"), "");
  run.run_until(0.5);
  for (const char *event : {"rf-tx", "rf-rx"}) {
    auto told = run.events(event);
    ASSERT_EQ(told.size(), 4u) << event;
    for (int i : {0, 2}) EXPECT_EQ(told[i].number("hops"), 3) << event;
    for (int i : {1, 3}) EXPECT_EQ(json_object_get(told[i].fields, "hops"), nullptr) << event;
    for (int i : {0, 1}) EXPECT_EQ(json_object_get(told[i].fields, "distance"), nullptr) << event;
    EXPECT_EQ(told[2].number("distance"), 3) << event;
    EXPECT_EQ(told[3].number("distance"), 0) << event;
  }
}

TEST(Injector, packets_wait_in_a_queue_that_has_an_end) {
  Scratch scratch;
  Emulation run(scratch, HEARER);
  std::string longest = R"({"do":"send","position":[140,0],"payload":")" + std::string(2 * 77, '5') + "\"}";
  for (int i = 0; i < 16; i++) EXPECT_EQ(run.command(longest), "");
  EXPECT_EQ(run.command(longest), "command: 16 packets wait to be sent; send this one when some of them are out");
  run.run_until(9);
  EXPECT_EQ(run.events("rf-tx").size(), 16u);
  EXPECT_EQ(run.events("far", "rf-rx").size(), 16u);
  EXPECT_TRUE(run.events("rf-damaged").empty());
  EXPECT_EQ(run.events("command").size(), 16u);
  EXPECT_EQ(run.command(longest), "");
}

TEST(Injector, collides_as_others_do) {
  Scratch scratch;
  Emulation run(scratch,
                R"({"boards":[{"name":"sender","firmware":"@rf_send"},{"name":"mirror","firmware":"@rf_mirror"}]})");
  run.run_until(0.06);
  EXPECT_EQ(run.command(R"({"do":"send","position":[0,0],"payload":")" + HELLO + "\"}"), "");
  run.run_until(0.4);
  auto collisions = run.events("mirror", "rf-collision");
  ASSERT_GE(collisions.size(), 1u);
  EXPECT_STREQ(json_string_value(json_array_get(json_object_get(collisions[0].fields, "boards"), 1)), "injector");
  EXPECT_EQ(run.events("mirror", "rf-damaged").size(), 2u);
}
