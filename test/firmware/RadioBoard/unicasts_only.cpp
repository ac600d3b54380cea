// A board whose sketch makes a JavinoUnicastBoard.

#include <gtest/gtest.h>

#include "support/Keys.h"
#include "support/Reference.h"
#include "support/TestBoard.h"

using javinolib::Counter;
using javinolib::Status;

namespace {

class UnicastsOnly : public testing::Test {
 protected:
  UnicastsOnly() {
    board.unicastsOnly = true;
    board.start("SUHO");
    board.setKey("SUPP", KEY);
  }

  static Bytes nonce(uint8_t counter) { return {0, 0, 9, 0, 0, counter}; }

  /// The keys that the board lists: of each, address, role and check value.
  std::vector<Bytes> keys() {
    const Bytes body = board.request('L').body;
    std::vector<Bytes> all;
    for (size_t at = 0; at < body.size(); at += 8) all.emplace_back(body.begin() + at, body.begin() + at + 8);
    return all;
  }

  /// Boots with a sketch of the other kind.
  void flash(bool unicastsOnly) {
    board.unicastsOnly = unicastsOnly;
    board.start();
  }

  TestBoard board;
};

}  // namespace

TEST_F(UnicastsOnly, says_so_in_hello) { EXPECT_EQ(7, board.hello().body.at(8)); }

TEST_F(UnicastsOnly, sends_and_receives_sealed_unicasts_with_proofs) {
  TestBoard whole;
  whole.start("SUPP");
  whole.setKey("SUHO", KEY);
  TestBoard *from = &board;
  TestBoard *to = &whole;
  for (const char *content : {"tell;there", "tell;back"}) {
    from->use();
    ASSERT_EQ(Status::OK,
              from->transmit(from == &board ? "SUPP" : "SUHO", from == &board ? "SUHO" : "SUPP", content).status);
    const Bytes frame = from->sendNext();
    to->use();
    to->receive(frame);
    ASSERT_EQ(1u, to->messages().size());
    EXPECT_EQ(content, to->messages()[0].content);
    to->pollTaking(0);
    const Bytes answer = to->sendNext();
    from->use();
    from->receive(answer);
    EXPECT_EQ(std::vector<std::string>{DELIVERED}, from->poll().texts('T'));
    std::swap(from, to);
  }
}

TEST_F(UnicastsOnly, takes_no_message_twice_nor_one_below_its_floor) {
  const Bytes frame = sealed(KEY, "SUHO", "SUPP", nonce(5), "tell;x");
  board.receive(frame);
  ASSERT_EQ(1u, board.messages().size());
  board.pollTaking(0);
  board.receive(frame);
  board.receive(sealed(KEY, "SUHO", "SUPP", nonce(4), "tell;y"));
  EXPECT_TRUE(board.messages().empty());
  board.powerUp();
  board.hello();
  board.request('R', {1});
  board.receive(frame);
  EXPECT_TRUE(board.messages().empty());
  EXPECT_FALSE(board.nextSent().empty()) << "it says stale";
}

TEST_F(UnicastsOnly, refuses_what_it_lacks) {
  for (char command : std::string("NUFY"))
    EXPECT_EQ(Status::UNICASTS_ONLY, board.request(command, bytesOf("SUPP") + OTHER_KEY).status);
  EXPECT_EQ(Status::UNICASTS_ONLY, board.setKey("//SU", KEY).status);
  for (const char *to : {"////", "//SU"}) EXPECT_EQ(Status::UNICASTS_ONLY, board.transmit(to, "SUHO", "tell;x").status);
  EXPECT_EQ(Status::BAD_DESTINATION, board.transmit("SUHO", "SUHO", "tell;x").status);
  EXPECT_EQ(Status::NO_KEY, board.transmit("SUPO", "SUHO", "tell;x").status);
  EXPECT_EQ(1u, keys().size());
}

TEST_F(UnicastsOnly, drops_what_is_for_many_though_it_has_the_groups_key) {
  flash(false);
  board.setKey("//SU", KEY);
  flash(true);
  ASSERT_EQ(2u, keys().size());
  board.receive(plain("////", "ROMA", "tell;help"));
  board.receive(sealed(KEY, "//SU", "SUPP", nonce(1), "tell;x"));
  EXPECT_TRUE(board.messages().empty());
  EXPECT_EQ(Status::OK, board.request('D', bytesOf("//SU")).status);
  EXPECT_EQ(1u, keys().size());
}

TEST_F(UnicastsOnly, keeps_of_an_unfinished_renewal_the_key_that_seals) {
  for (bool used : {false, true}) {
    flash(false);
    board.setKey("SUPP", KEY);
    ASSERT_EQ(Status::OK, board.request('N', bytesOf("SUPP") + OTHER_KEY).status);
    if (used) {
      ASSERT_EQ(Status::OK, board.request('U', bytesOf("SUPP")).status);
    }
    ASSERT_EQ(2u, keys().size());
    Bytes seals;
    for (const Bytes &key : keys()) {
      if (key[4] == 0) seals = key;
    }
    flash(true);
    EXPECT_EQ(std::vector<Bytes>{seals}, keys());
    board.receive(sealed(used ? KEY : OTHER_KEY, "SUHO", "SUPP", nonce(static_cast<uint8_t>(10 + used)), "tell;x"));
    EXPECT_TRUE(board.messages().empty());
    board.receive(sealed(used ? OTHER_KEY : KEY, "SUHO", "SUPP", nonce(static_cast<uint8_t>(20 + used)), "tell;x"));
    ASSERT_EQ(1u, board.messages().size());
    board.pollTaking(board.messages()[0].number);
    board.setKey("SUPP", THIRD_KEY);
    EXPECT_EQ(1u, keys().size());
    EXPECT_EQ(Status::OK, board.request('D', bytesOf("SUPP")).status);
    EXPECT_TRUE(keys().empty());
  }
}
