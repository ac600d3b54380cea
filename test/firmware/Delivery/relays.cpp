// Boards that are relays, on an air where each hears some others only (SPEC 7.5).
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "support/Air.h"
#include "support/Keys.h"
#include "support/Fragments.h"
#include "support/Reference.h"
#include "support/TestBoard.h"

using javinolib::Counter;
using javinolib::Status;

namespace {

BoardReply relaying(TestBoard &board, bool on, uint8_t number = 0) {
  return board.request('W', on ? Bytes{1, 0xBE, number} : Bytes{0});
}

// Boards on a line, of which each hears its neighbours. The first and the last one share a key.
struct Line {
  explicit Line(size_t hops, uint32_t seed = 1) : air(seed) {
    for (size_t i = 0; i <= hops; i++) {
      stations.emplace_back(new Station("SU" + std::string(1, static_cast<char>('A' + i)) + "A"));
      stations.back()->board.radio.mends = true;
      air.join(*stations.back());
    }
    first().share(last(), KEY);
    air.inRange = [this](const Station &one, const Station &other) { return std::abs(place(one) - place(other)) <= 1; };
    for (size_t i = 1; i < hops; i++) relay(i, true);
  }

  int place(const Station &station) const { return station.id[2] - 'A'; }
  Station &first() { return *stations.front(); }
  Station &last() { return *stations.back(); }

  BoardReply relay(size_t i, bool on) {
    stations[i]->board.use();
    return relaying(stations[i]->board, on);
  }

  uint32_t counter(size_t i, Counter counter) {
    stations[i]->board.use();
    return stations[i]->board.counter(counter);
  }

  Station::End send(const std::string &content) {
    EXPECT_TRUE(first().send(last().id, content));
    EXPECT_TRUE(air.settle(120000));
    return first().ended[content];
  }

  Air air;
  std::vector<std::unique_ptr<Station>> stations;
};

}  // namespace

// Their scores fall to 0 from the last one on, one with each message.
TEST(Relays, carry_messages_over_one_to_five_hops_and_their_acknowledgements_back) {
  for (size_t hops = 1; hops <= 5; hops++) {
    Line line(hops);
    std::vector<uint32_t> copies(hops), answers(hops);
    uint32_t resent = 0;
    for (size_t message = 1; message <= hops + 1; message++) {
      for (size_t i = 1; i < hops; i++) {
        copies[i] = line.counter(i, Counter::RELAY_COPIES);
        answers[i] = line.counter(i, Counter::RELAY_ANSWERS);
      }
      resent = line.counter(0, Counter::RADIO_RESENT);
      EXPECT_EQ(Station::DELIVERED, line.send("tell;n(" + std::to_string(message) + ")"));
    }
    EXPECT_EQ(hops + 1, line.last().received.size());
    for (size_t i = 1; i < hops; i++) {
      EXPECT_EQ(1u, line.counter(i, Counter::RELAY_COPIES) - copies[i]) << i << " of " << hops;
      EXPECT_GE(line.counter(i, Counter::RELAY_ANSWERS) - answers[i], 1u) << i << " of " << hops;
    }
    EXPECT_EQ(resent, line.counter(0, Counter::RADIO_RESENT));
  }
}

// It copies each packet before the other one can, and carries nothing back.
TEST(Relays, deliver_beside_one_that_carries_no_acknowledgement) {
  Line line(2);
  uint32_t untilCopy = 0;
  Bytes copied;
  line.air.onPacket = [&](const Bytes &packet) {
    if (packet.size() <= 26) return;
    copied = packet;
    untilCopy = 42 + 6 * static_cast<uint32_t>(packet.size()) + 16;
  };
  for (int i = 0; i < 5; i++) {
    const std::string content = "tell;n(" + std::to_string(i) + ")";
    ASSERT_TRUE(line.first().send(line.last().id, content));
    for (int millis = 0; millis < 60000 && !line.first().underWay.empty(); millis++) {
      line.air.step();
      if (untilCopy == 0 || --untilCopy != 0) continue;
      line.air.inject(copied, 1);
      untilCopy = 0;
    }
    EXPECT_EQ(Station::DELIVERED, line.first().ended[content]) << content;
  }
}

TEST(Relays, deliver_almost_all_where_packets_are_lost) {
  size_t delivered = 0;
  for (uint32_t seed = 1; seed <= 5; seed++) {
    Line line(4, seed);
    line.air.lostInThousand = 100;
    for (int i = 0; i < 20; i++) {
      if (line.send("tell;n(" + std::to_string(i) + ")") == Station::DELIVERED) delivered++;
    }
    std::vector<std::string> received = line.last().received;
    std::sort(received.begin(), received.end());
    EXPECT_EQ(received.end(), std::adjacent_find(received.begin(), received.end()));
  }
  EXPECT_GE(delivered, 98u);
}

TEST(Relays, do_nothing_once_they_are_switched_off) {
  Line line(2);
  EXPECT_EQ(Bytes{0}, line.relay(1, false).body);
  EXPECT_EQ(Station::UNDELIVERED, line.send("tell;help"));
  EXPECT_EQ(0u, line.counter(1, Counter::RADIO_SENT));
}

TEST(Relays, are_relays_after_a_reset_and_after_a_loss_of_power) {
  Line line(2);
  for (bool keepsRam : {true, false}) {
    line.stations[1]->board.use();
    line.stations[1]->reset(keepsRam);
    EXPECT_EQ(Bytes{1}, line.stations[1]->board.request('W').body);
    EXPECT_EQ(Station::DELIVERED, line.send(keepsRam ? "tell;one" : "tell;two"));
  }
}

// Neither has an RF id, and both have booted as often: all that differs is the number that their hosts gave them.
TEST(Relays, without_an_address_do_not_send_at_the_same_time) {
  TestBoard one;
  TestBoard two;
  for (TestBoard *board : {&one, &two}) {
    board->use();
    board->radio.mends = true;
    board->start();
    ASSERT_EQ(Bytes{1}, relaying(*board, true, board == &two).body);
  }
  int together = 0;
  for (int i = 0; i < 20; i++) {
    const Bytes packet = sealed(KEY, "SUPO", "ROMA", {0, 0, 1, 0, 0, static_cast<uint8_t>(i)}, "tell;help");
    int waited[2] = {0, 0};
    for (TestBoard *board : {&one, &two}) {
      board->use();
      board->pass(2000);
      board->receive(packet);
      const size_t before = board->radio.sent.size();
      while (board->radio.sent.size() == before && waited[board == &two]++ < 1500) board->pass(1);
      if (board->radio.sending()) board->finishSending();
    }
    if (std::abs(waited[0] - waited[1]) < 8) together++;
  }
  EXPECT_LT(together, 10);
}

TEST(Relays, write_nothing_where_nothing_changes) {
  Line line(2);
  line.stations[1]->board.use();
  line.stations[1]->board.eeprom.cutPowerAfter(0, 0);  // a write would throw
  EXPECT_EQ(Status::OK, line.relay(1, true).status);
  line.stations[1]->board.eeprom.restorePower();
}

TEST(Relays, cannot_be_boards_whose_radio_tells_no_hops) {
  TestBoard board;
  board.start();
  EXPECT_EQ(Status::UNKNOWN_COMMAND, relaying(board, true).status);
}

// Path 12 is no hop behind, and two ahead.
TEST(Relays, tell_how_far_their_own_message_goes_when_it_is_sent_first) {
  for (bool relays : {true, false}) {
    TestBoard board;
    board.start("SUPP");
    board.setKey("SUHO", KEY);
    board.start();
    board.radio.mends = true;
    relaying(board, relays);
    board.radio.arrive(plain("SUPP", "SUHO", "tell;x"), {}, javinolib::Trailer::NONE, 1);
    board.pass(1000);
    board.radio.behind.clear();
    board.transmit("SUHO", "SUPP", "tell;x");
    board.passSending(3000);
    const uint8_t path = relays ? 12 : 0;
    ASSERT_GE(board.radio.behind.size(), 2u);
    EXPECT_EQ(path, board.radio.behind[0]);
    EXPECT_EQ(0, board.radio.behind[1]) << "who is nearer does not bring it on";
  }
}

TEST(Relays, are_needed_by_none_who_hear_each_other) {
  Line line(2);
  line.air.inRange = nullptr;
  for (int i = 0; i < 10; i++) EXPECT_EQ(Station::DELIVERED, line.send("tell;n(" + std::to_string(i) + ")"));
  EXPECT_EQ(0u, line.counter(1, Counter::RADIO_SENT));
}

TEST(Relays, carry_broadcasts_and_multicasts_one_hop_and_to_nobody_twice) {
  for (const char *to : {"////", "//SU"}) {
    for (uint32_t seed = 1; seed <= 10; seed++) {
      Line line(3, seed);
      for (auto &station : line.stations) station->setKey("//SU", KEY);
      for (const char *content : {"tell;help", "tell;me"}) {
        ASSERT_TRUE(line.first().send(to, content));
        line.air.pass(5000);
      }
      const std::vector<std::string> both = {"tell;help", "tell;me"};
      EXPECT_EQ(both, line.stations[1]->received) << to;
      EXPECT_EQ(both, line.stations[2]->received) << to;
      EXPECT_TRUE(line.last().received.empty()) << to;
      EXPECT_EQ(2u, line.counter(1, Counter::RELAY_COPIES)) << to;
      EXPECT_EQ(0u, line.counter(2, Counter::RELAY_COPIES)) << to;
    }
  }
}

// A board that hears both the sender and a relay, or two relays, has it once; what is said again later, twice.
TEST(Relays, that_all_hear_each_other_copy_a_broadcast_once_and_have_it_delivered_once) {
  for (uint32_t seed = 1; seed <= 20; seed++) {
    Line line(3, seed);
    line.air.inRange = nullptr;
    for (size_t said = 1; said <= 2; said++) {
      ASSERT_TRUE(line.first().send("////", "tell;help"));
      line.air.pass(5000);
      EXPECT_EQ(said, line.last().received.size());
      EXPECT_EQ(said, line.stations[1]->received.size());
    }
  }
}

TEST(Relays, are_waited_for_by_a_sender_that_hears_a_copy) {
  Line line(2);
  EXPECT_EQ(Station::DELIVERED, line.send("tell;first"));
  const uint32_t resent = line.counter(0, Counter::RADIO_RESENT);
  line.last().awake = false;  // its host takes the message late
  ASSERT_TRUE(line.first().send(line.last().id, "tell;help"));
  line.air.pass(3000);
  EXPECT_EQ(resent, line.counter(0, Counter::RADIO_RESENT));
  line.last().awake = true;
  EXPECT_TRUE(line.air.settle(60000));
  EXPECT_EQ(Station::DELIVERED, line.first().ended["tell;help"]);
}

// It sends changed bytes, acknowledgements that it has made up, paths that are not so, and all of that again.
TEST(Relays, that_lie_have_nothing_delivered_twice_or_wrongly) {
  for (uint32_t seed = 1; seed <= 20; seed++) {
    Line line(2, seed);
    RandomBytes random(seed);
    std::vector<Bytes> heard;
    line.air.onPacket = [&](const Bytes &packet) { heard.push_back(packet); };
    for (int i = 0; i < 3; i++) {
      ASSERT_TRUE(line.first().send(line.last().id, "tell;n(" + std::to_string(i) + ")"));
    }
    for (int lie = 0; lie < 150; lie++) {
      line.air.pass(random.number(400));
      if (heard.empty()) continue;
      Bytes packet = heard[random.number(static_cast<uint32_t>(heard.size()))];
      switch (random.number(3)) {
        case 0:
          packet[random.number(static_cast<uint32_t>(packet.size()))] ^= static_cast<uint8_t>(1 + random.number(255));
          break;
        case 1:
          if (packet.size() > 26)
            packet = bytesOf("+K" +
                             std::string{static_cast<char>('A' + random.number(4)),
                                         static_cast<char>('A' + random.number(26))} +
                             line.last().id + "BA") +
                     random.bytes(8);
          break;
        default: break;
      }
      line.air.inject(packet, static_cast<uint8_t>(random.number(20)));
    }
    line.air.onPacket = nullptr;
    EXPECT_TRUE(line.air.settle(300000));
    std::vector<std::string> received = line.last().received;
    std::sort(received.begin(), received.end());
    EXPECT_EQ(received.end(), std::adjacent_find(received.begin(), received.end()));
    for (const auto &end : line.first().ended) {
      const auto times = std::count(received.begin(), received.end(), end.first);
      EXPECT_LE(times, 1);
      EXPECT_TRUE(end.second != Station::DELIVERED || times == 1) << end.first;
    }
    for (const std::string &content : received) EXPECT_EQ(1u, line.first().ended.count(content));
    EXPECT_TRUE(line.first().received.empty());
  }
}

// A relay's memory is the place of one of two messages in fragments.
TEST(Relays, take_one_message_in_fragments_at_a_time_and_two_when_they_are_none) {
  TestBoard board;
  board.radio.mends = true;
  board.start("SUHO");
  board.setKey("SUPP", KEY);
  board.setKey("SUPO", KEY);
  const std::string content(100, 'x');
  uint8_t counter = 0;
  for (bool relays : {true, false, true}) {
    ASSERT_EQ(Bytes{relays}, relaying(board, relays).body);
    const Bytes nonce = {0, 0, 1, 0, 0, ++counter};
    const std::vector<Bytes> one = cut(sealed(KEY, "SUHO", "SUPP", nonce, content), counter);
    const std::vector<Bytes> two = cut(sealed(KEY, "SUHO", "SUPO", nonce, content), counter);
    for (size_t i = 0; i < one.size(); i++) {
      board.receive(one[i]);
      board.receive(two[i]);
    }
    EXPECT_EQ(relays ? 1u : 2u, board.messages().size());
    board.pollTaking(static_cast<uint8_t>(counter == 1 ? 0 : counter == 2 ? 2 : 3));
  }
}

// Boards that were booted equally often have the same nonces: the frame of another one is no copy.
TEST(Relays, are_not_awaited_where_many_begin_at_once_in_the_same_epoch) {
  Line line(9);
  for (size_t i = 1; i < 9; i++) line.relay(i, false);
  line.air.inRange = nullptr;
  std::vector<std::unique_ptr<Station>> &all = line.stations;
  for (size_t i = 0; i < all.size(); i += 2) all[i]->share(*all[i + 1], KEY);
  for (size_t i = 0; i < all.size(); i += 2) EXPECT_TRUE(all[i]->send(all[i + 1]->id, "tell;help"));
  line.air.pass(50);
  for (size_t i = 1; i < all.size(); i += 2) EXPECT_TRUE(all[i]->send(all[i - 1]->id, "tell;help"));
  EXPECT_TRUE(line.air.settle(15000));
  for (const std::unique_ptr<Station> &station : all) {
    EXPECT_EQ(Station::DELIVERED, station->ended["tell;help"]) << station->id;
  }
}
