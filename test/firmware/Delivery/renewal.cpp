#include <gtest/gtest.h>

#include <algorithm>

#include "support/Air.h"
#include "support/Keys.h"

using javinolib::Status;

namespace {

const Bytes NEW_KEY = fromHex("8899aabbccddeeff0011223344556677");

// The keys of three stations, which all three renew: each pair's and the group's.
class Renewal : public testing::Test {
 protected:
  enum Step { BEGUN, ACCEPTS, SEALS, FINISHED };

  struct Message {
    int from;
    int to;  // the group where it is the sender itself
    std::string content;
  };

  void start(uint32_t seed) {
    air.reset(new Air(seed));
    stations.clear();
    messages.clear();
    for (const char *id : {"SUPO", "SUPP", "SUHO"}) {
      stations.emplace_back(new Station(id));
      stations.back()->setKey("//SU", THIRD_KEY);
      for (size_t other = 0; other + 1 < stations.size(); other++) stations[other]->share(*stations.back(), KEY);
      air->join(*stations.back());
    }
    steps = {BEGUN, BEGUN, BEGUN};
  }

  // Those with which a station shares a key.
  std::vector<std::string> addresses(int station) {
    std::vector<std::string> all = {"//SU"};
    for (int other = 0; other < 3; other++) {
      if (other != station) all.push_back(stations[other]->id);
    }
    return all;
  }

  // Asks a board for the next step with each of its keys; where it is busy, until it is not.
  void advance(int station) {
    const char command = "NUF"[steps[station]];
    for (const std::string &address : addresses(station)) {
      const Bytes body = bytesOf(address) + (command == 'N' ? address == "//SU" ? OTHER_KEY : NEW_KEY : Bytes());
      for (int tries = 0;; tries++) {
        ASSERT_LT(tries, 60000);
        stations[station]->board.use();
        const Status status = stations[station]->board.request(command, body).status;
        if (status == Status::OK) break;
        ASSERT_EQ(Status::BUSY, status) << command << address;
        busy++;
        air->pass(1);
      }
    }
    steps[station] = static_cast<Step>(steps[station] + 1);
  }

  // Whether a station may take its next step: the tool's rule.
  bool isDue(int station) const {
    const Step step = steps[station];
    return step != FINISHED && std::all_of(steps.begin(), steps.end(), [&](Step other) { return other >= step; });
  }

  void send(int from, int to) {
    const std::string content = "tell;m" + std::to_string(messages.size()) + "x";
    if (stations[from]->send(from == to ? "//SU" : stations[to]->id, content)) messages.push_back({from, to, content});
  }

  // Everybody speaks to everybody, and to the group.
  void sendAll() {
    for (int from = 0; from < 3; from++) {
      for (int to = 0; to < 3; to++) send(from, to);
    }
  }

  // The messages that arrived, and how often. Multicasts may be missing of which all copies collided with others.
  void expectAllArrived() {
    ASSERT_TRUE(air->settle(200000));
    std::map<std::pair<int, int>, long> missing;
    for (const Message &message : messages) {
      const Station::End end = stations[message.from]->ended[message.content];
      EXPECT_EQ(message.from == message.to ? Station::SENT : Station::DELIVERED, end) << message.content;
      for (int to = 0; to < 3; to++) {
        const bool isFor = to != message.from && (message.from == message.to || to == message.to);
        const std::vector<std::string> &received = stations[to]->received;
        const long times = std::count(received.begin(), received.end(), message.content);
        if (times == 0 && isFor && message.from == message.to) missing[{message.from, to}]++;
        EXPECT_TRUE(times == (isFor ? 1 : 0) || (times == 0 && message.from == message.to))
            << message.content << " from " << message.from << " to " << message.to << " at " << to;
      }
    }
    for (const auto &pair : missing) {
      EXPECT_LE(pair.second, air->missed(*stations[pair.first.first], *stations[pair.first.second]));
    }
    messages.clear();
    for (const auto &station : stations) station->received.clear();
  }

  // Calls back for each order of the steps that the rule allows: of each step the stations in any order. The stations are
  // alike, so that the first step's order is any.
  template <typename Visit>
  void inAllOrders(const Visit &visit) {
    std::vector<int> use = {0, 1, 2};
    do {
      std::vector<int> finish = {0, 1, 2};
      do {
        std::vector<int> order = {0, 1, 2};
        order.insert(order.end(), use.begin(), use.end());
        order.insert(order.end(), finish.begin(), finish.end());
        SCOPED_TRACE(testing::PrintToString(order));
        visit(order);
        if (HasFatalFailure()) return;
      } while (std::next_permutation(finish.begin(), finish.end()));
    } while (std::next_permutation(use.begin(), use.end()));
  }

  std::unique_ptr<Air> air;
  std::vector<std::unique_ptr<Station>> stations;
  std::vector<Step> steps;
  std::vector<Message> messages;
  int busy = 0;
};

}  // namespace

TEST_F(Renewal, in_all_orders_of_the_steps_every_message_between_them_arrives_once) {
  inAllOrders([this](const std::vector<int> &order) {
    start(1);
    sendAll();
    expectAllArrived();
    for (int station : order) {
      ASSERT_TRUE(isDue(station));
      advance(station);
      // The new and the old of each pair meet at each step: one direction and one multicast, in turn.
      send(station, (station + 1) % 3);
      send((station + 2) % 3, station);
      send(station, station);
      expectAllArrived();
    }
    EXPECT_EQ((std::vector<Step>{FINISHED, FINISHED, FINISHED}), steps);
  });
}

TEST_F(Renewal, in_all_orders_what_is_under_way_or_queued_at_each_step_arrives_once) {
  uint32_t seed = 0;
  inAllOrders([this, &seed](const std::vector<int> &order) {
    start(++seed);
    for (int station : order) {
      sendAll();
      air->pass(air->random.number(1500));
      advance(station);
    }
    expectAllArrived();
  });
  EXPECT_GT(busy, 20) << "some steps had to wait for a message";
}

TEST_F(Renewal, with_losses_resets_and_cuts_of_power_nothing_is_lost_but_by_these) {
  int delivered = 0;
  int sent = 0;
  for (uint32_t seed = 1; seed <= 10; seed++) {
    SCOPED_TRACE(seed);
    start(seed);
    air->lostInThousand = 30;
    while (steps != std::vector<Step>{FINISHED, FINISHED, FINISHED}) {
      const int station = static_cast<int>(air->random.number(3));
      send(station, static_cast<int>((static_cast<uint32_t>(station) + 1 + air->random.number(2)) % 3));
      air->pass(air->random.number(3000));
      if (isDue(station)) advance(station);
      if (air->random.number(8) == 0) stations[air->random.number(3)]->reset(air->random.number(2) != 0);
    }
    ASSERT_TRUE(air->settle(300000));
    for (const Message &message : messages) {
      const Station::End end = stations[message.from]->ended[message.content];
      const auto &received = stations[message.to]->received;
      const long times = std::count(received.begin(), received.end(), message.content);
      sent++;
      delivered += end == Station::DELIVERED;
      EXPECT_LE(times, 1);
      EXPECT_GE(times, end == Station::DELIVERED ? 1 : 0);
    }
    // And afterwards all is as it was.
    messages.clear();
    for (const auto &station : stations) station->received.clear();
    air->lostInThousand = 0;
    sendAll();
    ASSERT_TRUE(air->settle(300000));
    for (const Message &message : messages) {
      if (message.from == message.to) continue;
      EXPECT_EQ(Station::DELIVERED, stations[message.from]->ended[message.content]) << message.content;
    }
  }
  EXPECT_GT(delivered, sent * 8 / 10);
}

TEST_F(Renewal, a_step_whose_power_is_cut_is_taken_again_and_loses_nothing) {
  for (int cut : {0, 1, 2, 20, 34, 40, 45}) {
    SCOPED_TRACE(cut);
    start(7);
    for (int round = 0; round < 3; round++) {
      for (int station = 0; station < 3; station++) {
        Station &torn = *stations[station];
        torn.board.use();
        torn.board.eeprom.cutPowerAfter(cut, 0x5A);
        try {
          torn.board.request("NUF"[round], bytesOf("//SU") + (round == 0 ? OTHER_KEY : Bytes()));
        } catch (const PowerCut &) {
        }
        torn.board.eeprom.restorePower();
        torn.reset(false);
        // It has lost its RAM, too: it may refuse others' multicasts, which has nothing to do with keys.
        air->pass(3000);
        send(station, station);
        expectAllArrived();
        send((station + 1) % 3, station);
        expectAllArrived();
        // Again, as the tool's user does. What was done already it says.
        torn.board.use();
        const Status status =
            torn.board.request("NUF"[round], bytesOf("//SU") + (round == 0 ? OTHER_KEY : Bytes())).status;
        EXPECT_TRUE(status == Status::OK || (status == Status::NO_KEY && round != 0));
        send(station, station);
        expectAllArrived();
      }
    }
  }
}

TEST_F(Renewal, that_seals_before_all_accept_loses_messages) {
  start(1);
  advance(0);
  advance(0);
  send(0, 1);
  send(0, 0);
  ASSERT_TRUE(air->settle(200000));
  EXPECT_EQ(Station::UNDELIVERED, stations[0]->ended[messages[0].content]) << "so the tool's order is needed";
  EXPECT_TRUE(stations[1]->received.empty());
  EXPECT_TRUE(stations[2]->received.empty());
}
