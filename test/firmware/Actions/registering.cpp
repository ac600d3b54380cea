#include <Arduino.h>
#include <board/Actions.h>
#include <gtest/gtest.h>

#include "support/Bytes.h"

using javinolib::Actions;
using javinolib::Status;

namespace {

bool succeed(const javinolib::Arguments &) { return true; }
bool refuse(const javinolib::Arguments &) { return false; }

class ActionsTest : public testing::Test {
 protected:
  Status perform(const std::string &action) {
    const Bytes bytes = bytesOf(action);
    uint8_t reply[32];
    javinolib::Reply none(reply, sizeof reply);
    return actions.perform(bytes.data(), static_cast<uint16_t>(bytes.size()), none);
  }

  javinolib::SerialCounters counters;
  Actions actions{counters};
};

}  // namespace

TEST_F(ActionsTest, performs_what_was_named) {
  EXPECT_TRUE(actions.add(F("stop"), succeed));
  EXPECT_TRUE(actions.add(F("go"), refuse));
  EXPECT_EQ(Status::OK, perform("stop"));
  EXPECT_EQ(Status::OK, perform("stop(now)"));
  EXPECT_EQ(Status::ACTION_FAILED, perform("go"));
  EXPECT_EQ(Status::BAD_ARGUMENT, perform("stop("));
}

TEST_F(ActionsTest, knows_names_whole_only) {
  actions.add(F("stop"), succeed);
  for (const char *name : {"sto", "stopp", "Stop", "x", "stop_"}) {
    EXPECT_EQ(Status::UNKNOWN_ACTION, perform(name)) << name;
  }
  EXPECT_EQ(Status::BAD_ARGUMENT, perform(std::string("stop\0", 5)));
}

TEST_F(ActionsTest, refuses_names_that_are_taken_or_missing) {
  EXPECT_TRUE(actions.add(F("stop"), succeed));
  EXPECT_FALSE(actions.add(F("stop"), refuse));
  EXPECT_EQ(Status::OK, perform("stop"));
  EXPECT_FALSE(actions.add(F(""), succeed));
  EXPECT_FALSE(actions.add(nullptr, succeed));
  EXPECT_FALSE(actions.add(F("x"), nullptr));
}

TEST_F(ActionsTest, refuses_more_than_Config_says) {
  std::vector<std::string> names;
  for (int i = 0; i <= javinolib::config::ACTIONS; i++) names.push_back("action" + std::to_string(i));
  for (int i = 0; i < javinolib::config::ACTIONS; i++) EXPECT_TRUE(actions.add(F(names[i].c_str()), succeed));
  EXPECT_FALSE(actions.add(F(names.back().c_str()), succeed));
}
