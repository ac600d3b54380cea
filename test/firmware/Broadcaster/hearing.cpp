#include <delivery/Broadcaster.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/FakeClock.h"
#include "support/FakeRadio.h"

using javinolib::Broadcaster;

namespace {

std::vector<std::string> heard;

void hear(const char *from, const char *text) { heard.push_back(std::string(from) + " " + text); }

class HearingTest : public testing::Test {
 protected:
  HearingTest() : broadcaster(radio) {
    heard.clear();
    broadcaster.onHeard(hear);
    broadcaster.begin("CAFE");
  }

  // A packet ends now.
  void arrive(const std::string &packet, uint8_t hops = 0) {
    radio.mends = hops != 0;
    radio.arrive(bytesOf(packet), {}, javinolib::Trailer::NONE, hops);
    broadcaster.run();
  }

  FakeClock clock;
  FakeRadio radio;
  Broadcaster broadcaster;
};

}  // namespace

TEST_F(HearingTest, tells_who_says_what) {
  arrive("////ROMABItell;help");
  arrive("////SUPOAA");
  EXPECT_EQ((std::vector<std::string>{"ROMA tell;help", "SUPO "}), heard);
  EXPECT_EQ(0u, broadcaster.ignored());
  EXPECT_TRUE(radio.idle());
}

TEST_F(HearingTest, tells_the_longest_text) {
  const std::string text(67, 'x');
  arrive("////ROMAIY" + text);
  EXPECT_EQ(std::vector<std::string>{"ROMA " + text}, heard);
}

TEST_F(HearingTest, ignores_and_counts_all_else) {
  const char *const packets[] = {"x",                     // no frame
                                 "////ROMABItell;hel",    // too short for its size
                                 "////ROM-BItell;help",   // a digit that is none
                                 "SUPOROMABItell;help",   // to a device
                                 "//SUROMABItell;help",   // to a group
                                 "+FAAROMABItell;help",   // a fragment
                                 "////++++BItell;help",   // from no device
                                 "////CAFEBItell;help"};  // from its own address
  uint32_t count = 0;
  for (const char *packet : packets) {
    arrive(packet);
    EXPECT_EQ(++count, broadcaster.ignored()) << packet;
  }
  EXPECT_EQ(std::vector<std::string>(), heard);
}

TEST_F(HearingTest, tells_a_repeat_once_and_what_is_said_again_twice) {
  clock.millis = 1000;
  arrive("////ROMABItell;help");
  clock.millis = 1400;
  arrive("////ROMABItell;help");
  clock.millis = 5000;
  arrive("////ROMABItell;help");
  EXPECT_EQ(2u, heard.size());
  EXPECT_EQ(1u, broadcaster.ignored());
}

// 256 slots of 8 ms behind the 400 ms.
TEST_F(HearingTest, tells_what_a_relay_copies_once) {
  clock.millis = 1000;
  arrive("////ROMABItell;help", 1);
  clock.millis = 3448;
  arrive("////ROMABItell;help", 1);
  EXPECT_EQ(1u, heard.size());
  clock.millis += 3000;
  arrive("////ROMABItell;help", 1);
  EXPECT_EQ(2u, heard.size());
}

TEST_F(HearingTest, frees_the_radio_where_nobody_listens) {
  broadcaster.onHeard(nullptr);
  arrive("////ROMABItell;help");
  EXPECT_TRUE(radio.idle());
}
