#include <gtest/gtest.h>

#include <algorithm>

#include "support/Air.h"
#include "support/Keys.h"

using javinolib::Counter;

namespace {

const Bytes GROUP_KEY = fromHex("2b7e151628aed2a6abf7158809cf4f3c");

// A content of its own, of at least 12 bytes.
std::string content(int number, size_t length) {
  std::string text = "tell;m" + std::to_string(number) + ".";
  while (text.size() < length) text += static_cast<char>('a' + number % 26);
  return text;
}

long timesIn(const std::vector<std::string> &all, const std::string &one) {
  return std::count(all.begin(), all.end(), one);
}

// Stations of one group that share keys, each with each.
struct Field {
  Field(int count, uint32_t seed) : air(seed) {
    for (int i = 0; i < count; i++) {
      stations.emplace_back(new Station("SU" + std::string(1, static_cast<char>('A' + i)) + "A"));
      stations.back()->setKey("//SU", GROUP_KEY);
      for (int j = 0; j < i; j++) stations[j]->share(*stations[i], KEY);
      air.join(*stations.back());
    }
  }

  struct Unicast {
    Station *from;
    Station *to;
    std::string content;
  };

  void unicast(int from, int to, const std::string &text) {
    if (stations[from]->send(stations[to]->id, text))
      unicasts.push_back({stations[from].get(), stations[to].get(), text});
  }

  // The invariant, whatever happens: a message comes at the right one, at most once, and there if it was reported so.
  void check() {
    for (const Unicast &unicast : unicasts) {
      for (const auto &station : stations) {
        const long times = timesIn(station->received, unicast.content);
        EXPECT_LE(times, station.get() == unicast.to ? 1 : 0) << unicast.content.substr(0, 20);
        if (station.get() == unicast.to && unicast.from->ended[unicast.content] == Station::DELIVERED) {
          EXPECT_EQ(1, times) << "reported delivered: " << unicast.content.substr(0, 20);
        }
      }
    }
  }

  // Messages reached a station from another one in the order in which they were sent, and each sender learnt of them in that order.
  void checkOrder() {
    for (const auto &from : stations) {
      for (const auto &to : stations) {
        std::vector<std::string> sent, ends;
        for (const Unicast &unicast : unicasts) {
          if (unicast.from == from.get() && unicast.to == to.get()) sent.push_back(unicast.content);
        }
        const auto isOfThese = [&](const std::string &text) { return timesIn(sent, text) != 0; };
        std::copy_if(from->endedInOrder.begin(), from->endedInOrder.end(), std::back_inserter(ends), isOfThese);
        EXPECT_EQ(sent, ends) << from->id << " to " << to->id;
        std::vector<std::string> received, inOrder;
        std::copy_if(to->received.begin(), to->received.end(), std::back_inserter(received), isOfThese);
        std::copy_if(sent.begin(), sent.end(), std::back_inserter(inOrder),
                     [&](const std::string &text) { return timesIn(received, text) != 0; });
        EXPECT_EQ(inOrder, received) << from->id << " to " << to->id;
      }
    }
  }

  int delivered() {
    return static_cast<int>(std::count_if(unicasts.begin(), unicasts.end(), [](const Unicast &unicast) {
      return unicast.from->ended[unicast.content] == Station::DELIVERED;
    }));
  }

  Air air;
  std::vector<std::unique_ptr<Station>> stations;
  std::vector<Unicast> unicasts;
};

}  // namespace

TEST(Delivery, on_a_good_air_every_message_of_every_length_arrives_and_each_outcome_is_told) {
  Field field(2, 1);
  for (size_t length : {12, 53, 54, 67, 68, 120, 187, 188, 300, 493, 494}) {
    field.unicast(0, 1, content(static_cast<int>(length), length));
    ASSERT_TRUE(field.air.settle(20000)) << length;
    ASSERT_TRUE(field.stations[0]->send("////", content(static_cast<int>(1000 + length), length)));
    ASSERT_TRUE(field.air.settle(20000)) << length;
    ASSERT_TRUE(field.stations[0]->send("//SU", content(static_cast<int>(2000 + length), length)));
    ASSERT_TRUE(field.air.settle(20000)) << length;
    for (int kind : {0, 1000, 2000}) {
      EXPECT_EQ(1, timesIn(field.stations[1]->received, content(static_cast<int>(kind + length), length))) << length;
    }
    EXPECT_EQ(Station::SENT, field.stations[0]->ended[content(static_cast<int>(1000 + length), length)]);
    EXPECT_EQ(Station::SENT, field.stations[0]->ended[content(static_cast<int>(2000 + length), length)]);
  }
  EXPECT_EQ(11, field.delivered());
  field.check();
}

TEST(Delivery, two_that_send_to_each_other_at_the_same_time_both_succeed) {
  Field field(2, 2);
  for (int i = 0; i < 40; i++) {
    field.unicast(0, 1, content(2 * i, 12 + i));
    field.unicast(1, 0, content(2 * i + 1, 12 + i));
    ASSERT_TRUE(field.air.settle(20000)) << i;
  }
  EXPECT_EQ(80, field.delivered());
  field.check();
}

TEST(Delivery, over_many_seeds_and_losses_nothing_is_delivered_twice_or_falsely_reported) {
  int sent = 0;
  int delivered = 0;
  for (uint32_t seed = 1; seed <= 8; seed++) {
    SCOPED_TRACE(seed);
    Field field(2 + static_cast<int>(seed % 4), seed);
    field.air.lostInThousand = 40 * (seed % 8);
    const int count = static_cast<int>(field.stations.size());
    for (int i = 0; i < 10; i++) {
      const int from = static_cast<int>(field.air.random.number(static_cast<uint32_t>(count)));
      const int to = static_cast<int>(from + 1 + field.air.random.number(static_cast<uint32_t>(count - 1))) % count;
      const bool isLong = field.air.random.number(3) == 0;
      field.unicast(from, to, content(i, 12 + field.air.random.number(isLong ? 480 : 40)));
      if (i % 5 == 0) field.stations[from]->send(i % 2 == 0 ? "////" : "//SU", content(100 + i, 20));
      field.air.pass(field.air.random.number(1500));
    }
    EXPECT_TRUE(field.air.settle(300000)) << "every transmission ends";
    field.check();
    for (const auto &station : field.stations) {
      for (int i = 0; i < 10; i += 5) EXPECT_LE(timesIn(station->received, content(100 + i, 20)), 1);
    }
    sent += static_cast<int>(field.unicasts.size());
    delivered += field.delivered();
  }
  EXPECT_GT(sent, 60);
  EXPECT_GT(delivered, sent * 9 / 10);
}

TEST(Delivery, to_several_of_whom_some_are_away_each_gets_its_messages_in_order_and_each_end_is_told_once) {
  int delivered = 0;
  for (uint32_t seed = 1; seed <= 8; seed++) {
    SCOPED_TRACE(seed);
    Field field(6, seed);
    field.air.lostInThousand = 30 * (seed % 4);
    for (int i = 0; i < 40; i++) {
      // Those who are away hear nothing and come back later.
      for (int j = 1; j < 6; j++) {
        if (field.air.random.number(10) == 0) field.air.leave(*field.stations[j], field.air.random.number(2) != 0);
      }
      const int to = 1 + static_cast<int>(field.air.random.number(5));
      const bool isLong = field.air.random.number(6) == 0;
      const bool isFromOther = field.air.random.number(4) == 0;
      field.unicast(isFromOther ? to : 0, isFromOther ? 0 : to,
                    content(i, 12 + field.air.random.number(isLong ? 300 : 40)));
      if (i % 10 == 0) field.stations[0]->send(i % 20 == 0 ? "////" : "//SU", content(100 + i, 20));
      field.air.pass(field.air.random.number(800));
    }
    EXPECT_TRUE(field.air.settle(600000)) << "every transmission ends";
    field.check();
    field.checkOrder();
    delivered += field.delivered();
  }
  EXPECT_GT(delivered, 100);
}

TEST(Delivery, resets_of_either_side_with_and_without_their_RAM_deliver_nothing_twice) {
  int delivered = 0;
  for (uint32_t seed = 1; seed <= 8; seed++) {
    SCOPED_TRACE(seed);
    Field field(2, seed);
    field.air.lostInThousand = 100;
    for (int i = 0; i < 15; i++) {
      const int from = static_cast<int>(field.air.random.number(2));
      field.unicast(from, 1 - from, content(i, 12 + field.air.random.number(150)));
      field.air.pass(field.air.random.number(2000));
      if (field.air.random.number(3) == 0)
        field.stations[field.air.random.number(2)]->reset(field.air.random.number(2));
    }
    EXPECT_TRUE(field.air.settle(300000));
    field.check();
    delivered += field.delivered();
  }
  EXPECT_GT(delivered, 40);
}
