// A little of each attack, as gradle campaign runs them at length.

#include <gtest/gtest.h>

#include "Attack.h"
#include "support/Victim.h"

void PrintTo(const Attack &attack, std::ostream *out) { *out << attack.name; }

class EachAttack : public testing::TestWithParam<Attack> {};

TEST_P(EachAttack, is_refused_and_genuine_messages_arrive_in_between) {
  const Tally tally = GetParam().run(1, 5000);
  EXPECT_GE(tally.tries, 5000u);
  EXPECT_EQ(0u, tally.accepted);
  EXPECT_GE(tally.genuine, 2u);
  EXPECT_EQ(0u, tally.lost);
}

INSTANTIATE_TEST_SUITE_P(All, EachAttack, testing::ValuesIn(allAttacks()), [](const auto &info) {
  std::string name = info.param.name;
  for (char &character : name) {
    if (!isalnum(static_cast<unsigned char>(character))) character = '_';
  }
  return name;
});

// Tests of Victim: the events that the attacks count are seen where they happen.

TEST(Victim, counts_a_message_that_nobody_expects_as_accepted) {
  Victim victim(1);
  victim.suffer(victim.genuine(16, false));
  victim.take();
  EXPECT_EQ(1u, victim.tally.accepted);
}

TEST(Victim, counts_a_genuine_message_that_does_not_come_as_lost) {
  Victim victim(1);
  const Bytes frame = victim.genuine(16, false);
  victim.deliver(frame);
  victim.deliver(frame);
  EXPECT_EQ(2u, victim.tally.genuine);
  EXPECT_EQ(1u, victim.tally.lost);
}
