#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "support/Air.h"
#include "support/Keys.h"
#include "support/Fragments.h"
#include "support/TestBoard.h"

using javinolib::Counter;
using javinolib::Status;
using testing::ElementsAre;

namespace {

// A board SUPP with keys for devices of which nobody is there, unless a test says so.
class Partners : public testing::Test {
 protected:
  Partners() {
    board.start("SUPP");
    for (const char *address : {"SUAA", "SUBB", "SUCC", "SUDD", "SUEE", "//SU", "//RO"}) board.setKey(address, KEY);
    board.start();
  }

  int transmit(const std::string &to, const std::string &content = "tell;x") {
    const BoardReply reply = board.transmit(to, "SUPP", content);
    return reply.status == Status::OK ? reply.body.at(0) : -1;
  }

  // The next packet, when it has been sent.
  Bytes next() { return board.sendNext(); }
  std::string nextTo() { return textOf(next()).substr(0, 4); }

  void acknowledge(const Bytes &packet, uint8_t type = 6, const Bytes &body = Bytes()) {
    board.receive(acknowledgement(KEY, "SUPP", textOf(packet).substr(0, 4), nonceOf(packet), type, body));
  }

  static Bytes nonceOf(const Bytes &packet) { return Bytes(packet.begin() + 10, packet.begin() + 16); }

  // Numbers and outcomes, as the board tells them now.
  std::vector<std::string> outcomes() { return board.poll().texts('T'); }

  static std::string outcome(int number, Station::End end) {
    return {static_cast<char>(number), static_cast<char>(end)};
  }

  TestBoard board;
};

}  // namespace

TEST_F(Partners, take_turns_attempt_by_attempt) {
  transmit("SUAA");
  transmit("SUBB");
  for (int attempt = 1; attempt <= 8; attempt++) {
    EXPECT_TRUE(outcomes().empty());
    EXPECT_EQ("SUAA", nextTo()) << attempt;
    EXPECT_EQ("SUBB", nextTo()) << attempt;
  }
  board.passSending(5000);
  EXPECT_EQ(16u, board.radio.sent.size());
  EXPECT_THAT(outcomes(), ElementsAre(outcome(0, Station::UNDELIVERED), outcome(1, Station::UNDELIVERED)));
}

TEST_F(Partners, a_message_to_one_who_is_there_does_not_wait_for_those_who_are_not) {
  for (int i = 0; i < 3; i++) transmit("SUAA");
  EXPECT_EQ("SUAA", nextTo());
  transmit("SUBB");
  const Bytes packet = next();
  EXPECT_EQ("SUBB", textOf(packet).substr(0, 4));
  acknowledge(packet);
  EXPECT_THAT(outcomes(), ElementsAre(outcome(3, Station::DELIVERED))) << "before the three that were given earlier";
  for (int i = 0; i < 3; i++) {
    for (int attempt = i == 0 ? 2 : 1; attempt <= 8; attempt++) EXPECT_EQ("SUAA", nextTo());
  }
  board.pass(1000);
  EXPECT_THAT(outcomes(), ElementsAre(outcome(0, Station::UNDELIVERED), outcome(1, Station::UNDELIVERED),
                                      outcome(2, Station::UNDELIVERED)));
}

TEST_F(Partners, each_gets_its_messages_in_order_with_rising_nonces) {
  std::map<std::string, std::vector<Bytes>> nonces;
  for (int i = 0; i < 4; i++) {
    for (const char *to : {"SUAA", "SUBB"}) transmit(to, "tell;x" + std::to_string(i));
  }
  for (int packet = 0; packet < 8 * 8; packet++) {
    const Bytes sent = next();
    std::vector<Bytes> &seen = nonces[textOf(sent).substr(0, 4)];
    if (seen.empty() || seen.back() != nonceOf(sent)) seen.push_back(nonceOf(sent));
  }
  ASSERT_EQ(2u, nonces.size());
  for (const auto &partner : nonces) {
    EXPECT_EQ(4u, partner.second.size()) << "the second begins when the first has ended";
    EXPECT_TRUE(std::is_sorted(partner.second.begin(), partner.second.end()));
  }
}

TEST_F(Partners, an_acknowledgement_that_comes_when_another_has_its_turn_is_taken) {
  transmit("SUAA");
  transmit("SUBB");
  const Bytes first = next();
  const Bytes second = board.nextSent();
  acknowledge(first);
  EXPECT_THAT(outcomes(), ElementsAre(outcome(0, Station::DELIVERED)));
  board.finishSending();
  acknowledge(second);
  EXPECT_THAT(outcomes(), ElementsAre(outcome(1, Station::DELIVERED)));
  board.passSending(2000);
  EXPECT_EQ(2u, board.radio.sent.size());
  acknowledge(first);
  EXPECT_EQ(1u, board.counter(Counter::RADIO_NOT_FOR_US));
  EXPECT_EQ(0u, board.counter(Counter::RADIO_BAD_PROOFS));
}

TEST_F(Partners, an_acknowledgement_of_what_was_never_sent_is_about_nothing) {
  TestBoard fresh;
  fresh.start("SUPP");
  fresh.setKey("AAAA", KEY);
  for (uint8_t type : {6, 7, 8}) {
    const Bytes body = type == 6 ? Bytes() : type == 7 ? Bytes{1} : Bytes(8, 0);
    fresh.receive(acknowledgement(KEY, "AAAA", "AAAA", Bytes(6, 0), type, body));
  }
  EXPECT_EQ(3u, fresh.counter(Counter::RADIO_NOT_FOR_US));
}

TEST_F(Partners, a_record_that_is_not_the_first_leaves_the_others_as_they_were) {
  for (const char *to : {"SUAA", "SUBB", "SUCC"}) transmit(to, "tell;to" + std::string(to));
  const Bytes a = next();
  const Bytes b = next();
  const Bytes c = next();
  acknowledge(b);
  EXPECT_EQ(a, next());
  EXPECT_EQ(c, next());
  acknowledge(a);
  EXPECT_EQ(c, next());
  EXPECT_THAT(outcomes(), ElementsAre(outcome(1, Station::DELIVERED), outcome(0, Station::DELIVERED)));
}

TEST_F(Partners, four_are_under_way_and_a_fifth_has_the_place_of_the_one_that_ends_first) {
  for (const char *to : {"SUAA", "SUBB", "SUCC", "SUDD", "SUEE"}) {
    transmit(to);
    acknowledge(next());
  }
  for (const char *to : {"SUAA", "SUBB", "SUCC", "SUDD", "SUEE"}) transmit(to);
  std::vector<Bytes> round;
  for (int i = 0; i < 4; i++) round.push_back(next());
  for (const Bytes &packet : round) EXPECT_EQ(packet, next());
  acknowledge(round[2]);
  std::set<std::string> after;
  for (int i = 0; i < 4; i++) after.insert(nextTo());
  EXPECT_EQ((std::set<std::string>{"SUAA", "SUBB", "SUDD", "SUEE"}), after);
}

TEST_F(Partners, a_new_message_goes_before_those_that_wait_for_a_further_attempt) {
  transmit("SUAA");
  transmit("SUBB");
  EXPECT_EQ("SUAA", nextTo());
  EXPECT_EQ("SUBB", textOf(board.nextSent()).substr(0, 4));
  transmit("SUCC");
  board.finishSending();
  EXPECT_EQ("SUCC", nextTo());
  EXPECT_EQ("SUAA", nextTo());
  EXPECT_EQ("SUBB", nextTo());
}

TEST_F(Partners, a_new_message_takes_the_turn_from_one_that_contends_for_a_further_attempt) {
  for (int times = 0; times < 20; times++) {
    transmit("SUAA");
    for (int attempt = 1; attempt <= 4; attempt++) EXPECT_EQ("SUAA", nextTo());
    board.pass(600);
    if (board.radio.sending()) continue;
    transmit("SUBB");
    board.pass(1);
    EXPECT_TRUE(board.radio.sending());
    const Bytes packet = next();
    EXPECT_EQ("SUBB", textOf(packet).substr(0, 4));
    acknowledge(packet);
    for (int attempt = 5; attempt <= 8; attempt++) EXPECT_EQ("SUAA", nextTo());
    board.passSending(1000);
    return;
  }
  FAIL();
}

TEST_F(Partners, a_multicast_keeps_its_turn_though_a_new_message_comes) {
  transmit("//SU");
  EXPECT_EQ("//SU", nextTo());
  transmit("SUBB");
  EXPECT_EQ("//SU", nextTo());
  EXPECT_EQ("SUBB", nextTo());
}

TEST_F(Partners, when_32_new_messages_have_gone_before_the_same_one_places_take_turns) {
  transmit("SUAA");
  EXPECT_EQ("SUAA", nextTo());
  transmit("SUBB");
  std::string turns;
  while (turns.size() < 32 + 8) {
    const Bytes packet = next();
    turns += textOf(packet).at(2);
    if (turns.back() == 'A') continue;
    transmit("SUBB");
    acknowledge(packet);
    outcomes();
  }
  EXPECT_EQ(std::string(32, 'B'), turns.substr(0, 32));
  EXPECT_GE(std::count(turns.begin(), turns.end(), 'A'), 2) << turns;
}

TEST_F(Partners, the_last_free_place_is_for_one_that_acknowledged_its_last_message) {
  transmit("SUEE");
  acknowledge(next());
  outcomes();
  for (const char *to : {"SUAA", "SUBB", "SUCC", "SUDD"}) transmit(to);
  for (const char *to : {"SUAA", "SUBB", "SUCC", "SUAA", "SUBB", "SUCC"}) EXPECT_EQ(to, nextTo());
  transmit("SUEE");
  std::map<std::string, int> sent;
  while (outcomes().empty()) sent[nextTo()]++;
  EXPECT_EQ(0, sent["SUDD"]);
  EXPECT_GE(sent["SUEE"], 5);
}

TEST_F(Partners, the_last_free_place_is_for_many_too) {
  for (const char *to : {"SUAA", "SUBB", "SUCC", "SUDD", "//SU"}) transmit(to);
  for (const char *to : {"SUAA", "SUBB", "SUCC", "//SU", "//SU", "SUAA"}) EXPECT_EQ(to, nextTo());
}

TEST_F(Partners, another_waits_for_one_message_of_those_who_are_absent_not_for_all_of_theirs) {
  for (int i = 0; i < 3; i++) {
    for (const char *to : {"SUAA", "SUBB", "SUCC"}) transmit(to, "x");
  }
  transmit("SUEE", "x");
  for (int attempt = 0; attempt < 3 * 7 + 1; attempt++) EXPECT_NE("SUEE", nextTo());
  EXPECT_EQ("SUEE", nextTo());
}

TEST_F(Partners, what_goes_to_many_keeps_its_order_and_waits_for_no_absent_device) {
  transmit("SUAA");
  transmit("//SU");
  transmit("////");
  transmit("//RO");
  EXPECT_EQ("SUAA", nextTo());
  EXPECT_EQ("//SU", nextTo());
  EXPECT_EQ("//SU", nextTo()) << "its second time, before another has its turn";
  std::vector<std::string> rest;
  for (int i = 0; i < 5; i++) rest.push_back(nextTo());
  rest.erase(std::remove(rest.begin(), rest.end(), "SUAA"), rest.end());
  EXPECT_THAT(rest, ElementsAre("////", "//RO", "//RO"));
  EXPECT_THAT(outcomes(), ElementsAre(outcome(1, Station::SENT), outcome(2, Station::SENT), outcome(3, Station::SENT)));
}

TEST_F(Partners, a_key_is_not_taken_into_use_while_a_message_under_it_waits_for_its_turn) {
  for (const char *to : {"SUAA", "SUBB", "SUCC"}) board.request('N', bytesOf(to) + OTHER_KEY);
  transmit("SUAA");
  transmit("SUBB");
  const Bytes first = next();
  board.nextSent();
  EXPECT_EQ(Status::BUSY, board.request('U', bytesOf("SUAA")).status);
  EXPECT_EQ(Status::BUSY, board.request('U', bytesOf("SUBB")).status);
  EXPECT_EQ(Status::OK, board.request('U', bytesOf("SUCC")).status);
  acknowledge(first);
  EXPECT_EQ(Status::OK, board.request('U', bytesOf("SUAA")).status);
  EXPECT_EQ(Status::BUSY, board.request('U', bytesOf("SUBB")).status);
}

TEST_F(Partners, a_key_that_is_deleted_no_longer_acknowledges_what_waits_for_its_turn) {
  transmit("SUAA");
  transmit("SUBB");
  const Bytes first = next();
  const Bytes second = next();
  board.request('D', bytesOf("SUAA"));
  board.setKey("SUAA", KEY);
  acknowledge(first);
  EXPECT_THAT(outcomes(), ElementsAre(outcome(0, Station::UNDELIVERED)));
  acknowledge(second);
  EXPECT_THAT(outcomes(), ElementsAre(outcome(1, Station::DELIVERED)));
}

TEST_F(Partners, a_stale_notice_for_one_that_waits_for_its_turn_has_it_sealed_anew) {
  transmit("SUAA");
  transmit("SUBB");
  const Bytes first = next();
  board.nextSent();
  Bytes notice = nonceOf(first);
  notice[5] = static_cast<uint8_t>(notice[5] + 20);
  acknowledge(first, 8, notice + Bytes{0xFF, 0xFF});
  board.finishSending();
  Bytes above = notice;
  above[5]++;
  EXPECT_EQ(sealed(KEY, "SUAA", "SUPP", above, "tell;x"), next());
  EXPECT_EQ("SUBB", nextTo());
}

TEST_F(Partners, a_stale_notice_for_a_multicast_counts_though_others_were_taken_up_since) {
  transmit("SUAA");
  transmit("//SU");
  next();
  const Bytes multicast = next();
  next();
  Bytes notice = nonceOf(multicast);
  notice[5] = static_cast<uint8_t>(notice[5] + 20);
  board.receive(acknowledgement(KEY, "SUPP", "SUEE", nonceOf(multicast), 8, notice + Bytes{0, 1}));
  EXPECT_EQ(0u, board.counter(Counter::RADIO_BAD_PROOFS));
  transmit("SUBB");
  Bytes sent;
  while (textOf(sent).substr(0, 4) != "SUBB") sent = next();
  EXPECT_EQ(notice[5] + 1, sent.at(15));
}

TEST_F(Partners, messages_in_fragments_to_several_are_told_apart) {
  transmit("SUAA", std::string(150, 'a'));
  transmit("SUBB", std::string(150, 'b'));
  std::vector<Bytes> sent;
  for (int i = 0; i < 4; i++) sent.push_back(next());
  EXPECT_NE(sent[0].at(2), sent[3].at(2)) << "the ids";
  const Bytes nonce(sent[0].begin() + 20, sent[0].begin() + 26);
  board.receive(acknowledgement(KEY, "SUPP", "SUAA", nonce, 7, {0x05}));
  for (int i = 0; i < 2; i++) EXPECT_EQ(sent[3].at(2), next().at(2)) << "the other one has its turn";
  EXPECT_EQ(wantingAnswer(sent[1]), next()) << "what the first one lacks";
  EXPECT_EQ(wantingAnswer(sent[3]), next());
  EXPECT_EQ(wantingAnswer(sent[1]), next()) << "the one that has just asked";
}

TEST_F(Partners, no_number_is_given_while_the_transmission_of_256_before_has_no_outcome) {
  std::set<int> open;
  while (open.size() < 16) open.insert(transmit("SUAA"));
  int others = 0;
  while (open.count(15) != 0) {
    for (const char *to : {"////", "SUBB", "SUCC"}) {
      const int number = transmit(to, "x");
      ASSERT_TRUE(number < 0 || open.insert(number).second) << "number " << number << " is still open";
      if (number >= 0) others++;
    }
    for (int left = 1000; left != 0 && !board.radio.sending(); left--) board.pass(1);
    if (board.radio.sending()) {
      board.finishSending();
      const Bytes packet = board.radio.sent.back();
      const std::string to = textOf(packet).substr(0, 4);
      if (to == "SUBB" || to == "SUCC") acknowledge(packet);
    }
    for (const std::string &end : outcomes()) open.erase(static_cast<uint8_t>(end.at(0)));
  }
  EXPECT_GT(others, 200);
}

TEST(Delivery, to_one_who_is_there_takes_less_than_two_seconds_while_others_are_not) {
  for (uint32_t seed = 1; seed <= 20; seed++) {
    SCOPED_TRACE(seed);
    Air air(seed);
    Station from("SUPP");
    Station there("SUHO");
    from.share(there, KEY);
    from.setKey("SUAA", KEY);
    air.join(from);
    air.join(there);
    air.pass(air.random.number(500));
    for (int i = 0; i < 3; i++) ASSERT_TRUE(from.send("SUAA", "tell;a" + std::to_string(i)));
    air.pass(air.random.number(1000));
    ASSERT_TRUE(from.send("SUHO", "tell;b"));
    air.pass(2000);
    EXPECT_EQ(Station::DELIVERED, from.ended["tell;b"]);
    EXPECT_EQ(0u, from.ended.count("tell;a2"));
    ASSERT_TRUE(air.settle(60000));
    for (int i = 0; i < 3; i++) EXPECT_EQ(Station::UNDELIVERED, from.ended["tell;a" + std::to_string(i)]);
  }
}
