// SPDX-License-Identifier: GPL-3.0-or-later
// The USB bridge: when bytes are passed on. Times are in milliseconds.
#include "support.h"

extern "C" {
#include "bridge.h"
}

static constexpr cycles_t ms(double time) { return static_cast<cycles_t>(time * CYCLES_PER_MS); }

static bridge started(double latency, double at = 0) {
  bridge b = {};
  b.latency = ms(latency);
  bridge_start(&b, ms(at));
  return b;
}

static void put(bridge &b, int bytes, double at) {
  for (int i = 0; i < bytes; i++) bridge_put(&b, ms(at));
}

TEST(Bridge, without_latency_holds_nothing_back) {
  bridge b = {};
  put(b, 3, 5);
  EXPECT_EQ(bridge_held(&b, ms(5)), 0u);
}

TEST(Bridge, bytes_wait_for_the_timer_which_did_not_start_with_them) {
  bridge b = started(16);
  put(b, 1, 10);
  put(b, 2, 12);
  EXPECT_EQ(bridge_held(&b, ms(16) - 1), 3u);
  EXPECT_EQ(bridge_held(&b, ms(16)), 0u);
}

TEST(Bridge, a_byte_at_the_end_of_the_timer_waits_for_the_next_one) {
  bridge b = started(16);
  put(b, 1, 16);
  EXPECT_EQ(bridge_held(&b, ms(32) - 1), 1u);
  EXPECT_EQ(bridge_held(&b, ms(32)), 0u);
}

TEST(Bridge, empty_packets_start_the_timer_too) {
  bridge b = started(16, 3);
  EXPECT_EQ(bridge_held(&b, ms(40)), 0u);  // packets at 19 and 35
  put(b, 1, 100);                          // packets at 51, 67, 83 and 99
  EXPECT_EQ(bridge_held(&b, ms(115) - 1), 1u);
  EXPECT_EQ(bridge_held(&b, ms(115)), 0u);
}

TEST(Bridge, a_full_packet_goes_at_once_and_starts_the_timer) {
  bridge b = started(16);
  put(b, BRIDGE_PACKET - 1, 4);
  EXPECT_EQ(bridge_held(&b, ms(5)), 61u);
  put(b, 1, 5);
  EXPECT_EQ(bridge_held(&b, ms(5)), 0u);
  put(b, 1, 6);
  EXPECT_EQ(bridge_held(&b, ms(21) - 1), 1u);
  EXPECT_EQ(bridge_held(&b, ms(21)), 0u);
}

TEST(Bridge, bytes_that_the_timer_has_sent_do_not_fill_the_next_packet) {
  bridge b = started(16);
  put(b, BRIDGE_PACKET - 1, 15);
  put(b, 1, 17);
  EXPECT_EQ(bridge_held(&b, ms(17)), 1u);
}

TEST(Bridge, starting_empties_the_packet) {
  bridge b = started(16);
  put(b, 5, 10);
  bridge_start(&b, ms(12));
  EXPECT_EQ(bridge_held(&b, ms(12)), 0u);
  put(b, 1, 20);
  EXPECT_EQ(bridge_held(&b, ms(28) - 1), 1u);
  EXPECT_EQ(bridge_held(&b, ms(28)), 0u);
}
