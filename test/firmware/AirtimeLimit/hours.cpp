// No hour has more than its share (SPEC 7.6), whatever is sent when.
#include <delivery/AirtimeLimit.h>
#include <delivery/Relay.h>
#include <gtest/gtest.h>

#include <deque>
#include <random>

#include "support/Keys.h"
#include "support/TestBoard.h"

using javinolib::AirtimeLimit;
using javinolib::Counter;

namespace {

const uint32_t HOUR = 3600000;

Bytes packet(const std::string &destination, size_t length = 40) {
  return bytesOf(destination + "ROMADw") + Bytes(length - 10, 7);
}

class Limited : public testing::Test {
 protected:
  Limited() { radio.mends = true; }

  // One that begins after a boot, whether the RAM was kept or not.
  void boot(uint8_t percent) {
    clock.millis = 0;
    limit.reset(::new AirtimeLimit(radio, percent));
  }

  bool send(const Bytes &payload, uint8_t path = 0) {
    *radio.sentPath() = path;
    const bool taken = limit->send(payload.data(), static_cast<uint8_t>(payload.size()));
    if (taken) radio.finishSending();
    *radio.sentPath() = 0;
    return taken;
  }

  // Sends as much as goes, for so long.
  uint32_t sendAll(const std::string &to, uint8_t path = 0) {
    const size_t before = radio.sent.size();
    while (send(packet(to), path)) {
    }
    return static_cast<uint32_t>(radio.sent.size() - before);
  }

  uint32_t wait() {
    javinolib::RadioCounters counters = {};
    limit->counters(counters);
    return counters.airtimeWait;
  }

  void passUntilFull() { clock.millis += HOUR / 7; }

  FakeClock clock;
  SimulatedRam ram;
  FakeRadio radio;
  std::unique_ptr<AirtimeLimit> limit;
};

}  // namespace

// The time of each packet within a window is counted, also of one that hangs over its beginning.
TEST_F(Limited, each_hour_has_at_most_its_share_whatever_is_sent_and_reset) {
  std::mt19937 random(64);
  for (uint8_t percent : {1, 10}) {
    boot(percent);
    uint64_t start = 0;  // of this boot
    std::deque<std::pair<uint64_t, uint32_t>> sent;
    uint64_t inWindow = 0;
    uint64_t most = 0;
    for (int i = 0; i < 50000; i++) {
      const bool isFull = i >= 20000;  // it is full, and then all of it is used for an hour
      if (i == 20000) clock.millis += HOUR / 6;
      const uint32_t choice = random() % 1000;
      clock.millis += isFull        ? random() % (1000u / percent + 100)
                      : choice == 0 ? random() % (2 * HOUR)
                      : choice < 20 ? random() % 60000
                                    : random() % 300;
      if (choice == 999 && !isFull) {
        start += clock.millis;
        boot(percent);
      }
      const size_t length = 26 + random() % 52;
      const Bytes payload = packet(random() % 2 ? "+KAA" : random() % 2 ? "SUPO" : "+FAB", length);
      if (!send(payload, random() % 4 == 0)) continue;
      const uint32_t lasts = radio.airtimeMillis(static_cast<uint8_t>(length));
      const uint64_t end = start + clock.millis + lasts;
      clock.millis += lasts;
      sent.push_back({end, lasts});
      inWindow += lasts;
      while (sent.front().first + HOUR <= end) {
        inWindow -= sent.front().second;
        sent.pop_front();
      }
      const auto &first = sent.front();
      const uint64_t before = first.first - first.second + HOUR < end ? end - HOUR - (first.first - first.second) : 0;
      most = std::max(most, inWindow - before);
    }
    EXPECT_LE(most, HOUR / 100 * percent) << int(percent);
    EXPECT_GE(most, HOUR / 100 * percent / 10 * 9) << int(percent) << ": it is used";
  }
}

TEST_F(Limited, sends_seven_eighths_of_its_share_in_the_long_run_and_an_eighth_at_once) {
  boot(10);
  passUntilFull();
  const uint32_t lasts = radio.airtimeMillis(40);
  EXPECT_NEAR(HOUR / 10 / 8, sendAll("+KAA") * (lasts + 1), lasts);
  uint32_t sent = 0;
  for (uint32_t at = 0; at < HOUR; at += 500) {
    clock.millis += 500;
    sent += sendAll("+KAA");
  }
  EXPECT_NEAR(HOUR / 10 / 8 * 7, sent * (lasts + 1), lasts);
}

TEST_F(Limited, leaves_an_eighth_to_acknowledgements_and_a_quarter_before_relays_copies) {
  boot(10);
  passUntilFull();
  const uint32_t eighth = HOUR / 10 / 8;
  const uint32_t lasts = radio.airtimeMillis(40) + 1u;
  EXPECT_NEAR(eighth / 4 * 3, sendAll("SUPO", 1) * lasts, lasts);
  EXPECT_EQ(0u, sendAll("+KAA", 5)) << "a copy of an acknowledgement";
  EXPECT_NEAR(eighth / 8, sendAll("SUPO") * lasts, lasts);
  EXPECT_EQ(0u, sendAll("////"));
  EXPECT_EQ(0u, sendAll("+FAA"));
  EXPECT_EQ(0u, sendAll("+FAI"));
  EXPECT_EQ(0u, sendAll("SUPO", 8)) << "it tells a distance only";
  EXPECT_TRUE(send(packet("+FAB"))) << "what goes on with a message";
  EXPECT_TRUE(send(packet("+FAJ")));
  EXPECT_NEAR(eighth / 8, (sendAll("+KAA") + 2) * lasts, lasts);
}

// What its receiver has of a message it forgets 5 s after a fragment; 1 % of a second is 10 ms.
TEST_F(Limited, begins_with_fragments_once_all_of_them_may_be_sent) {
  boot(1);
  clock.millis += HOUR / 7 * 4 / 5;
  EXPECT_TRUE(send(packet("SUPO", 77)));
  EXPECT_FALSE(send(packet("+FAA", 77)));
  passUntilFull();
  EXPECT_TRUE(send(packet("+FAA", 77)));
  for (int i = 1; i < 8; i++) EXPECT_TRUE(send(packet("+FAB", 77))) << i;
}

TEST_F(Limited, tells_how_long_a_new_message_waits) {
  boot(10);
  passUntilFull();
  EXPECT_EQ(0u, wait());
  while (send(packet("SUPO", 77))) {
  }
  const uint32_t seconds = wait();
  EXPECT_GT(seconds, 0u);
  EXPECT_LE(seconds, 7u) << "what a packet takes comes back in 6 s";
  clock.millis += (seconds - 1) * 1000;
  EXPECT_FALSE(send(packet("SUPO", 77)));
  EXPECT_EQ(1u, wait());
  clock.millis += 1000;
  EXPECT_EQ(0u, wait());
  EXPECT_TRUE(send(packet("SUPO", 77)));
  sendAll("+KAA");
  EXPECT_NEAR(HOUR / 7 / 8 / 1000, wait(), 8);
}

TEST_F(Limited, goes_on_after_a_reset_and_begins_spent_after_a_loss_of_power_or_with_another_share) {
  boot(10);
  EXPECT_FALSE(send(packet("+KAA"))) << "at first";
  clock.millis += 4000;
  EXPECT_TRUE(send(packet("+KAA")));
  clock.millis += 60000;
  wait();
  boot(10);
  EXPECT_TRUE(send(packet("+KAA")));
  boot(9);
  EXPECT_FALSE(send(packet("+KAA")));
  boot(10);
  clock.millis += 60000;
  wait();
  ram.airtime.level++;
  EXPECT_FALSE(send(packet("+KAA"))) << "a reset while it was written";
  clock.millis += 60000;
  wait();
  ram.losePower();
  boot(10);
  EXPECT_FALSE(send(packet("+KAA")));
}

TEST_F(Limited, takes_nothing_for_what_its_radio_refuses_and_more_for_a_trailer) {
  boot(10);
  passUntilFull();
  wait();
  const uint32_t level = ram.airtime.level;
  radio.refuses = true;
  EXPECT_FALSE(send(packet("+KAA")));
  EXPECT_EQ(level, ram.airtime.level);
  radio.refuses = false;
  EXPECT_TRUE(send(packet("+KAA")));
  const uint32_t plain = level - ram.airtime.level;
  limit->follow(javinolib::Trailer::PARITY, 40);
  EXPECT_TRUE(send(packet("+KAA")));
  EXPECT_EQ(plain + 13 * 6 * 800, level - ram.airtime.level - plain) << "13 bytes of 6 ms";
}

TEST(LimitedSlowRadio, sends_a_packet_that_leaves_no_reserve_once_its_level_is_full) {
  class SlowRadio : public FakeRadio {
    uint16_t airtimeMillis(uint8_t length) const override { return static_cast<uint16_t>(55 * length); }
  } radio;
  FakeClock clock;
  SimulatedRam ram;
  AirtimeLimit limit(radio, 1);
  const Bytes payload = packet("SUPO", 77);
  for (int i = 0; i < 2; i++) {
    clock.millis += HOUR / 7 + 1;
    EXPECT_TRUE(limit.send(payload.data(), 77)) << "4.2 of 4.5 s";
    radio.finishSending();
    clock.millis += HOUR / 28;
    EXPECT_FALSE(limit.send(payload.data(), 77));
  }
}

// A board whose limit is used up by what others ask of it keeps its message until it may send that, and loses no attempt.
TEST(LimitedBoard, waits_with_a_unicast_without_losing_attempts) {
  FakeRadio radio;
  AirtimeLimit limit(radio, 1);
  TestBoard board(&limit);
  board.start("SUPP");
  board.setKey("SUHO", KEY);
  board.transmit("SUHO", "SUPP", "tell;x");
  size_t seconds = 0;
  for (; radio.sent.empty() && seconds < 1000; seconds++) board.pass(1000);
  EXPECT_NEAR(HOUR / 7 / 8 / 1000 + 26, seconds, 5) << "until an eighth and the packet are there";
  EXPECT_EQ(0u, board.counter(Counter::RADIO_RESENT));
  EXPECT_LT(0u, board.counter(Counter::AIRTIME_WAIT));
  const Bytes first = radio.sent[0];
  while (board.counter(Counter::RADIO_UNDELIVERED) == 0 && seconds++ < 3000) {
    if (radio.sending()) radio.finishSending();
    board.pass(100);
  }
  EXPECT_EQ(std::vector<Bytes>(8, first), radio.sent);
}
