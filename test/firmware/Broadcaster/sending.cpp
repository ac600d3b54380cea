#include <delivery/Broadcaster.h>
#include <gtest/gtest.h>

#include <string>

#include "support/FakeClock.h"
#include "support/FakeRadio.h"

using javinolib::Broadcaster;

namespace {

class BroadcasterTest : public testing::Test {
 protected:
  BroadcasterTest() : broadcaster(radio) {}

  // Lets time pass in which the air is as it is.
  void pass(uint32_t millis) {
    for (uint32_t end = clock.millis + millis; clock.millis < end; clock.millis++) broadcaster.run();
  }

  FakeClock clock;
  FakeRadio radio;
  Broadcaster broadcaster;
};

}  // namespace

TEST_F(BroadcasterTest, sends_a_text_as_a_frame_to_all) {
  ASSERT_TRUE(broadcaster.begin("CAFE"));
  ASSERT_TRUE(broadcaster.send("Hello!"));
  pass(500);
  ASSERT_EQ(1u, radio.sent.size());
  EXPECT_EQ("////CAFEAwHello!", textOf(radio.sent[0]));
  EXPECT_FALSE(broadcaster.isBusy());
}

TEST_F(BroadcasterTest, sends_at_once_when_the_air_has_been_quiet) {
  broadcaster.begin("CAFE");
  pass(500);
  broadcaster.send("Hello!");
  broadcaster.run();
  EXPECT_EQ(1u, radio.sent.size());
}

TEST_F(BroadcasterTest, waits_while_a_carrier_is_heard) {
  broadcaster.begin("CAFE");
  radio.heard = true;
  broadcaster.send("Hello!");
  pass(1000);
  EXPECT_EQ(0u, radio.sent.size());
  EXPECT_TRUE(broadcaster.isBusy());
  radio.heard = false;
  pass(500);
  EXPECT_EQ(1u, radio.sent.size());
}

TEST_F(BroadcasterTest, does_not_take_the_time_of_a_carrier_for_quiet_that_came_and_went_while_it_did_not_look) {
  broadcaster.begin("CAFE");
  pass(20);
  broadcaster.send("Hello!");
  radio.wasHeard = true;
  clock.millis += 900;
  broadcaster.run();
  EXPECT_EQ(0u, radio.sent.size());
  pass(500);
  EXPECT_EQ(1u, radio.sent.size());
}

TEST_F(BroadcasterTest, looks_once_more_before_it_sends) {
  static FakeRadio *air;
  air = &radio;
  broadcaster.begin("CAFE");
  broadcaster.onHeard([](const char *, const char *) { air->wasHeard = true; });
  pass(500);
  broadcaster.send("Hello!");
  radio.arrive(bytesOf("////BEEFAwHello!"));
  broadcaster.run();
  EXPECT_EQ(0u, radio.sent.size()) << "a carrier came and went while the sketch was told of a text";
  pass(500);
  EXPECT_EQ(1u, radio.sent.size());
}

TEST_F(BroadcasterTest, takes_one_text_while_the_one_before_is_on_the_air_and_no_more) {
  broadcaster.begin("CAFE");
  pass(500);
  ASSERT_TRUE(broadcaster.send("one"));
  EXPECT_FALSE(broadcaster.send("two"));
  broadcaster.run();
  EXPECT_TRUE(broadcaster.send("two"));
  EXPECT_FALSE(broadcaster.send("three"));
  pass(500);
  EXPECT_EQ(1u, radio.sent.size());
  radio.finishSending();
  pass(500);
  ASSERT_EQ(2u, radio.sent.size());
  EXPECT_EQ("////CAFEAYtwo", textOf(radio.sent[1]));
}

TEST_F(BroadcasterTest, sends_what_fits_a_packet_and_refuses_the_rest) {
  broadcaster.begin("CAFE");
  EXPECT_FALSE(broadcaster.send(""));
  EXPECT_FALSE(broadcaster.send(std::string(68, 'x').c_str()));
  EXPECT_TRUE(broadcaster.send(std::string(67, 'x').c_str()));
  pass(500);
  ASSERT_EQ(1u, radio.sent.size());
  EXPECT_EQ(77u, radio.sent[0].size());
}

TEST_F(BroadcasterTest, tries_again_where_the_radio_does_not_take_it) {
  broadcaster.begin("CAFE");
  radio.refuses = true;
  broadcaster.send("Hello!");
  pass(500);
  EXPECT_TRUE(broadcaster.isBusy());
  radio.refuses = false;
  pass(500);
  EXPECT_EQ(1u, radio.sent.size());
}

TEST_F(BroadcasterTest, says_where_the_address_is_no_devices) {
  for (const char *address : {"", "CAF", "CAFES", "CA-E", "////", "//SU", "++++", "+FAA"}) {
    EXPECT_FALSE(broadcaster.begin(address)) << address;
  }
}

TEST_F(BroadcasterTest, says_where_the_radio_does_not_start) {
  radio.works = false;
  EXPECT_FALSE(broadcaster.begin("CAFE"));
}
