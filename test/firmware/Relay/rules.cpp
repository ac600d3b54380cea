// The rules of SPEC 7.5, one by one, of a board that only relays.
#include <delivery/Relay.h>
#include <gtest/gtest.h>

#include "support/Digits.h"
#include "support/FakeClock.h"
#include "support/FakeRadio.h"

using javinolib::Relay;

namespace {

// SPEC 6.
uint8_t pathOf(uint8_t hops, uint8_t distance) { return static_cast<uint8_t>(hops + 4 + 4 * distance); }

const uint32_t SLOT = 8;
const uint32_t LONGEST = 158 * SLOT;     // until a first copy that may not be needed
const uint32_t LONGEST_NEW = 24 * SLOT;  // and of one that is

// A sealed frame of 16 bytes of content, as far as a relay can tell.
Bytes unicast(uint8_t number, const std::string &to = "SUPO", const std::string &from = "ROMA") {
  return bytesOf(to + from + "Dw") + Bytes{0, 0, 1, 0, 0, number} + Bytes(24, number);
}

// 12 bits of 0…255 are the digits AA…D/.
std::string digitsOf(uint8_t number) { return std::string{digits()[number >> 6], digits()[number & 63]}; }

Bytes answer(uint8_t number, uint8_t proof = 0x5A, const std::string &from = "SUPO") {
  return bytesOf("+K" + digitsOf(number) + from + "BA") + Bytes(8, proof);
}

class RelayTest : public testing::Test {
 protected:
  explicit RelayTest(uint8_t slower = 1) : relay(radio) {
    radio.mends = true;
    radio.slower = slower;
    EXPECT_TRUE(relay.begin(7));
    pass(100);
  }

  // The packet on the air ends after its time.
  void pass(uint32_t millis) {
    for (; millis != 0; millis--) {
      clock.millis++;
      if (radio.sending() && --untilEnd_ == 0) radio.finishSending();
      const size_t before = radio.sent.size();
      relay.run();
      if (radio.sent.size() != before) untilEnd_ = radio.airtimeMillis(static_cast<uint8_t>(radio.sent.back().size()));
    }
  }

  // Another board's packet takes its time on the air.
  void hear(const Bytes &packet, uint8_t path = 0) {
    radio.heard = true;
    pass(radio.airtimeMillis(static_cast<uint8_t>(packet.size())));
    radio.heard = false;
    radio.arrive(packet, {}, javinolib::Trailer::NONE, path);
    pass(1);
  }

  // Lets the relay begin a packet, at most so many ms later, and end it.
  bool sends(uint32_t millis) {
    const size_t before = radio.sent.size();
    while (millis-- != 0 && radio.sent.size() == before) pass(1);
    if (radio.sent.size() == before) return false;
    while (radio.sending()) pass(1);
    pass(1);
    return true;
  }

  // A packet that no relay copies, from the receiver of the others.
  void hearReceiver(uint8_t hops) { hear(unicast(0, "+FAA", "SUPO"), hops); }

  // A message that this relay carries there and whose acknowledgement it carries back.
  void carry(uint8_t number) {
    hear(unicast(number));
    ASSERT_TRUE(sends(LONGEST));
    hear(answer(number));
    ASSERT_TRUE(sends(10 * SLOT));
  }

  FakeClock clock;
  FakeRadio radio;
  Relay relay;

 private:
  uint32_t untilEnd_ = 0;
};

}  // namespace

TEST_F(RelayTest, copies_a_unicast_that_nobody_answers_byte_by_byte_with_one_hop_more) {
  for (uint8_t hops = 0; hops < 4; hops++) {
    const Bytes packet = unicast(hops);
    hear(packet, hops);
    EXPECT_TRUE(sends(LONGEST));
    EXPECT_EQ(packet, radio.sent.back());
    EXPECT_EQ((hops + 1) % 4, radio.behind.back());
  }
  EXPECT_EQ(4u, relay.copies());
}

TEST_F(RelayTest, waits_for_an_answer_at_first_and_for_eight_slots_where_it_is_needed) {
  for (uint8_t i = 0; i < 20; i++) {
    hear(unicast(i, "SUPO", "RO" + digitsOf(i)));
    EXPECT_FALSE(sends(30 * SLOT - 1)) << int(i);
    pass(1500);
  }
  carry(20);
  hear(unicast(21));
  EXPECT_FALSE(sends(8 * SLOT - 1));
  EXPECT_TRUE(sends(9 * SLOT));
}

TEST_F(RelayTest, neither_copies_nor_carries_back_what_is_answered_at_once) {
  for (uint8_t i = 0; i < 20; i++) {
    hear(unicast(i));
    hear(answer(i));
    EXPECT_FALSE(sends(3000)) << "what another has answered is neither copied nor carried back";
    clock.millis += 2000;
  }
}

TEST_F(RelayTest, copies_no_fragments_and_nothing_odd) {
  for (const char *to : {"+FAA", "+AAA"}) {
    hear(unicast(1, to));
    EXPECT_FALSE(sends(3000)) << to;
  }
  hear(bytesOf("SUPOROMABIx"));   // no frame
  hear(bytesOf("SUPOROMAAQab"));  // no nonce
  hear(answer(9));
  EXPECT_FALSE(sends(3000));
}

TEST_F(RelayTest, copies_what_is_for_many_once_however_often_it_comes) {
  for (const Bytes &packet : {unicast(1, "//SU"), bytesOf("////ROMAAIx")}) {
    hear(packet);
    EXPECT_TRUE(sends(9 * SLOT));
    EXPECT_EQ(packet, radio.sent.back());
    EXPECT_EQ(1, radio.behind.back());
    hear(packet);
    hear(packet, 1);
    EXPECT_FALSE(sends(3000));
  }
  EXPECT_EQ(2u, relay.copies());
}

TEST_F(RelayTest, leaves_what_is_for_many_to_a_peer) {
  for (uint8_t hops : {1, 2}) {
    hear(unicast(hops, "////"));
    hear(unicast(hops, "////"), 1);
    EXPECT_FALSE(sends(3000));
  }
}

TEST_F(RelayTest, copies_no_copy_of_what_is_for_many) {
  for (uint8_t hops : {1, 2}) {
    hear(unicast(hops, "////"), hops);
    EXPECT_FALSE(sends(3000));
    hear(unicast(hops, "////"), hops);
    EXPECT_FALSE(sends(3000)) << "nor late";
  }
}

// Its receivers would take it for another one.
TEST_F(RelayTest, copies_what_is_for_many_soon_or_not_at_all) {
  hear(unicast(1, "////"));
  radio.heard = true;
  pass(256 * SLOT);
  radio.heard = false;
  EXPECT_FALSE(sends(3000));
  EXPECT_EQ(1u, relay.refused());
  hear(unicast(2, "////"));
  radio.heard = true;
  pass(200 * SLOT);
  radio.heard = false;
  EXPECT_TRUE(sends(3000));
}

TEST_F(RelayTest, spends_as_much_on_what_is_for_many_and_keeps_its_air_for_unicasts) {
  uint32_t sent = 0;
  const uint32_t begun = clock.millis;
  for (uint8_t i = 0; i < 200; i++) {
    hear(unicast(i, "////"));
    if (sends(50 * SLOT)) sent += radio.airtimeMillis(40);
  }
  const uint32_t all = clock.millis - begun;
  EXPECT_LE(sent, all / 10 + 4000);
  EXPECT_GE(sent, all / 12);
  carry(201);
}

TEST_F(RelayTest, keeps_silent_where_a_peer_or_somebody_downstream_was_quicker) {
  for (uint8_t hops : {1, 2}) {
    hear(unicast(hops));
    hear(unicast(hops), hops);
    EXPECT_FALSE(sends(3000)) << int(hops);
  }
}

TEST_F(RelayTest, carries_the_acknowledgement_of_what_it_copied) {
  hear(unicast(1), 1);
  ASSERT_TRUE(sends(LONGEST));
  hear(answer(1));
  EXPECT_TRUE(sends(5 * SLOT));
  EXPECT_EQ(answer(1), radio.sent.back());
  EXPECT_EQ(pathOf(1, 2), radio.behind.back());
  EXPECT_EQ(1u, relay.answers());
  // The sender was not heard itself: twice more, unless it is heard farther on.
  EXPECT_TRUE(sends(30 * SLOT));
  hear(answer(1), pathOf(2, 1));
  EXPECT_FALSE(sends(3000));
}

TEST_F(RelayTest, carries_an_acknowledgement_from_downstream_alone) {
  const uint8_t own = 2;
  for (uint8_t its = 0; its < 4; its++) {
    hear(unicast(its, "SUPO", "RO" + digitsOf(its)), 1);
    ASSERT_TRUE(sends(LONGEST));
    pass(30 * SLOT);
    hear(answer(its), pathOf(1, its));
    EXPECT_EQ((its - own) % 4 == 1 || (own - its) % 4 == 2, sends(5 * SLOT)) << int(its);
    pass(3000);
  }
}

TEST_F(RelayTest, leaves_a_packet_to_those_who_are_nearer) {
  hear(unicast(1), pathOf(0, 2));
  EXPECT_FALSE(sends(3000)) << "it does not know how far that is";
  hearReceiver(1);
  for (uint8_t told = 0; told < 4; told++) {
    hear(unicast(static_cast<uint8_t>(2 + told), "SUPO", "RO" + digitsOf(told)), pathOf(0, told));
    EXPECT_EQ(told == 3, sends(LONGEST_NEW)) << int(told);
    pass(3000);
  }
}

TEST_F(RelayTest, copies_soon_and_tells_the_distance_where_it_knows_that) {
  for (uint8_t hops = 0; hops < 4; hops++) {
    for (int i = 0; i < 4; i++) hearReceiver(hops);
    hear(unicast(hops));
    EXPECT_FALSE(sends(8 * SLOT - 1));
    ASSERT_TRUE(sends(16 * SLOT + 1));
    EXPECT_EQ(pathOf(1, (hops + 1) % 4), radio.behind.back());
    pass(3000);
  }
}

TEST_F(RelayTest, takes_a_greater_distance_at_the_fourth_time_and_a_smaller_one_at_once) {
  const std::vector<std::vector<uint8_t>> heard = {{0}, {1}, {1}, {1, 0}, {2}, {1}, {2}, {0}, {1, 1, 1}, {2}};
  const std::vector<uint8_t> distances = {1, 1, 1, 1, 1, 1, 1, 1, 1, 3};
  for (uint8_t i = 0; i < heard.size(); i++) {
    for (uint8_t hops : heard[i]) hearReceiver(hops);
    hear(unicast(i, "SUPO", "RO" + digitsOf(i)));
    ASSERT_TRUE(sends(LONGEST_NEW));
    EXPECT_EQ(pathOf(1, distances[i]), radio.behind.back()) << int(i);
    pass(10000);
  }
  hearReceiver(1);
  hear(unicast(20));
  ASSERT_TRUE(sends(LONGEST_NEW));
  EXPECT_EQ(pathOf(1, 2), radio.behind.back());
}

TEST_F(RelayTest, begins_late_with_what_others_who_are_nearer_have_not_brought_on) {
  hear(unicast(1), pathOf(0, 2));
  pass(1600);
  hear(unicast(1));
  ASSERT_TRUE(sends(LONGEST));
  EXPECT_EQ(1, radio.behind.back()) << "late: it tells no distance";
}

TEST_F(RelayTest, carries_no_acknowledgement_of_another_packet) {
  hear(unicast(1));
  ASSERT_TRUE(sends(LONGEST));
  hear(answer(2));
  hear(answer(1, 0x5A, "ROMA"));
  EXPECT_FALSE(sends(3000));
}

TEST_F(RelayTest, repeats_its_copy_once_only_where_it_has_no_doubt) {
  hear(unicast(1));
  ASSERT_TRUE(sends(LONGEST));
  EXPECT_FALSE(sends(1400));
  carry(2);
  hear(unicast(3));
  ASSERT_TRUE(sends(17 * SLOT));
  EXPECT_TRUE(sends(80 * SLOT));
  EXPECT_EQ(unicast(3), radio.sent.back());
  EXPECT_FALSE(sends(3000));
}

TEST_F(RelayTest, copies_again_what_its_sender_sends_again) {
  hear(unicast(1));
  ASSERT_TRUE(sends(LONGEST));
  hear(unicast(1));
  EXPECT_TRUE(sends(60 * SLOT));
  EXPECT_EQ(2u, relay.copies());
}

TEST_F(RelayTest, begins_anew_with_what_is_heard_again_late) {
  hear(unicast(1), 1);
  ASSERT_TRUE(sends(LONGEST));
  hear(unicast(1), 1);
  EXPECT_FALSE(sends(1300));
  pass(500);
  for (uint8_t path : {2, 3}) {
    hear(unicast(1), path);
    EXPECT_FALSE(sends(3000)) << "a copy of its own copy, or beside it";
  }
  hear(unicast(1), 1);
  EXPECT_TRUE(sends(LONGEST));
  EXPECT_EQ(2, radio.behind.back());
}

// At 300 bit/s a packet is on the air for longer than its repetition is late after on an ASK pair.
class SlowRelayTest : public RelayTest {
 protected:
  SlowRelayTest() : RelayTest(7) {}
};

TEST_F(SlowRelayTest, takes_no_repetition_that_took_its_time_for_late) {
  hear(unicast(1), 1);
  ASSERT_TRUE(sends(7 * LONGEST));
  hear(unicast(1), 1);
  EXPECT_FALSE(sends(7 * LONGEST));
  hear(unicast(1), 1);
  EXPECT_TRUE(sends(7 * LONGEST));
}

TEST_F(RelayTest, gives_the_acknowledgement_again_and_after_four_times_the_packet) {
  carry(1);
  for (int i = 1; i < 4; i++) {
    pass(300);
    hear(unicast(1));
    ASSERT_TRUE(sends(60 * SLOT)) << i;
    EXPECT_EQ(answer(1), radio.sent.back());
  }
  pass(300);
  hear(unicast(1));
  ASSERT_TRUE(sends(60 * SLOT));
  EXPECT_EQ(unicast(1), radio.sent.back());
}

// The other one may be a liar that carries nothing back.
TEST_F(RelayTest, carries_an_acknowledgement_late_of_what_another_has_copied) {
  hear(unicast(1));
  hear(unicast(1), 1);
  hear(answer(1));
  hear(unicast(1));
  EXPECT_FALSE(sends(1000));
  pass(600);
  hear(unicast(1));
  ASSERT_TRUE(sends(60 * SLOT));
  EXPECT_EQ(answer(1), radio.sent.back());
  EXPECT_EQ(0u, relay.copies());
}

TEST_F(RelayTest, is_in_reserve_where_others_carry_all) {
  for (uint8_t i = 1; i <= 2; i++) {
    hear(unicast(i));
    hear(answer(i));
  }
  hear(unicast(3));
  EXPECT_FALSE(sends(3000));
  hear(unicast(3));
  EXPECT_FALSE(sends(52 * SLOT));
  EXPECT_TRUE(sends(10 * SLOT));
  hear(answer(3));
  EXPECT_TRUE(sends(5 * SLOT));
}

TEST_F(RelayTest, spends_a_tenth_of_the_air_on_unproved_pairs) {
  uint32_t sent = 0;
  const uint32_t begun = clock.millis;
  for (int i = 0; i < 400; i++) {
    const std::string origin = "X" + digitsOf(static_cast<uint8_t>(i / 2)) + "A";
    hear(unicast(static_cast<uint8_t>(i), "SUPO", origin));
    if (sends(LONGEST)) sent += radio.airtimeMillis(40);
  }
  const uint32_t all = clock.millis - begun;
  EXPECT_LE(sent, all / 10 + 4000);
  EXPECT_GE(sent, all / 12);
  EXPECT_GT(relay.refused(), 100u);
}

TEST_F(RelayTest, serves_those_whose_messages_arrive_before_unproved_pairs) {
  carry(1);
  for (uint8_t i = 0; i < 40; i++) {
    hear(unicast(i, "XXXX", "YYYY"));
    sends(LONGEST);
  }
  EXPECT_GT(relay.refused(), 0u);
  hear(unicast(2));
  EXPECT_TRUE(sends(17 * SLOT));
  EXPECT_EQ(unicast(2), radio.sent.back());
}

TEST_F(RelayTest, carries_both_acknowledgements_of_packets_that_are_alike_but_for_their_end) {
  Bytes forged = unicast(1);
  forged.back() ^= 1;
  hear(forged);
  hear(unicast(1));
  ASSERT_TRUE(sends(LONGEST));
  ASSERT_TRUE(sends(LONGEST));
  EXPECT_NE(radio.sent[0], radio.sent[1]);
}

TEST_F(RelayTest, bears_random_packets) {
  RandomBytes random(5);
  for (int i = 0; i < 20000; i++) {
    Bytes packet = random.number(3) == 0 ? answer(static_cast<uint8_t>(random.number(8)))
                                         : unicast(static_cast<uint8_t>(random.number(8)));
    if (random.number(4) == 0) packet = random.bytes(1 + random.number(77));
    if (!radio.sending()) radio.arrive(packet, {}, javinolib::Trailer::NONE, static_cast<uint8_t>(random.number(20)));
    pass(random.number(300));
  }
  for (const Bytes &packet : radio.sent) EXPECT_TRUE(packet.size() == 40 || packet.size() == 18);
}

TEST_F(RelayTest, tells_its_share_of_the_air_since_the_boot) {
  EXPECT_EQ(0u, relay.airtime());
  for (uint8_t number = 1; number <= 8; number++) carry(number);
  uint32_t sent = 0;
  for (const Bytes &packet : radio.sent) sent += radio.airtimeMillis(static_cast<uint8_t>(packet.size()));
  const uint32_t seconds = clock.millis / 1000;
  EXPECT_EQ(sent / 1000 * 1000 / seconds, relay.airtime());
  clock.millis = UINT32_MAX - 500;  // 49 days later, of which it saw nothing
  pass(1);
  const uint16_t before = relay.airtime();
  pass(50000);
  EXPECT_GT(before, relay.airtime()) << "the clock begins anew";
  EXPECT_LT(0u, relay.airtime());
}

TEST(RelayRadio, must_tell_paths) {
  FakeClock clock;
  FakeRadio radio;
  EXPECT_FALSE(Relay(radio).begin());
}
