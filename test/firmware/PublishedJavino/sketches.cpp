// Sketches as they are written for the published library, and a host that speaks our protocol.

#include <Arduino.h>
#include <ArduinoMock.h>
#include <arduino/PublishedJavino.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <support/Status.h>

#include "support/MockedLine.h"
#include "support/Reference.h"

using javinolib::Status;

namespace {

typedef std::vector<std::string> Texts;

bool lampIsOn;
int calls;

void lampOn() { lampIsOn = true; }
void lampOff() { lampIsOn = false; }

class OlderSketch : public testing::Test {
 protected:
  OlderSketch() {
    lampIsOn = false;
    calls = 0;
    ON_CALL(arduino, millis()).WillByDefault(testing::ReturnPointee(&now));
  }

  // Sends a request.
  void send(const Bytes &message) {
    line.arrive(Bytes{0} + reference::packet(++sequence, reference::frame("++++", "++++", message)));
    line.out.clear();
  }

  // Sends one that the sketch's loop() takes.
  void ask(const Bytes &message) {
    send(message);
    javino.run();
  }

  void poll(uint8_t hold = 100) { ask({'P', 1, 0, hold, 0, 0, 0}); }

  // Status and body of the last reply, after all that came before.
  Bytes reply() {
    Bytes packet;
    Bytes last;
    for (uint8_t byte : line.out) {
      if (byte != 0) {
        packet.push_back(byte);
      } else {
        if (!packet.empty()) last = packet;
        packet.clear();
      }
    }
    line.out.clear();
    const Bytes inner = reference::cobsDecoded(last);
    return Bytes(inner.begin() + 11, inner.end() - 2);
  }

  Status act(const std::string &action) {
    ask(bytesOf("A" + action));
    return static_cast<Status>(reply().at(0));
  }

  bool answered() const { return line.out.size() > 2; }

  // The percepts of the last poll's reply, which must be a reading.
  Texts told() {
    const Bytes body = reply();
    EXPECT_EQ(4, body.at(1)) << "a reading that is whole";
    Texts texts;
    for (size_t at = 2; at < body.size(); at += 3 + body[at + 2]) {
      texts.push_back(textOf(Bytes(body.begin() + at + 3, body.begin() + at + 3 + body[at + 2])));
    }
    return texts;
  }

  testing::NiceMock<ArduinoMock> arduino;
  MockedLine line;
  unsigned long now = 0;
  uint8_t sequence = 0;
  Javino javino;
};

class PublishedJavino : public OlderSketch {
 protected:
  PublishedJavino() {
    javino.start(9600);
    ask({'H', 1});
  }
};

// Its sketches open the line themselves, by Serial.begin(9600).
class FirstJavino : public OlderSketch {};

}  // namespace

TEST_F(PublishedJavino, opens_the_line_as_fast_as_hosts_do) {
  EXPECT_CALL(line.serial, begin(115200));
  javino.start(9600);
}

TEST_F(PublishedJavino, performs_actions_by_their_names) {
  javino.act["lampOn"] = lampOn;
  javino.act["lampOff"] = lampOff;
  EXPECT_EQ(Status::OK, act("lampOn"));
  EXPECT_TRUE(lampIsOn);
  EXPECT_EQ(Status::OK, act("lampOff(now)"));
  EXPECT_FALSE(lampIsOn);
  javino.act["lampOff"] = lampOn;
  EXPECT_EQ(Status::OK, act("lampOff"));
  EXPECT_TRUE(lampIsOn) << "the function that was set last";
}

TEST_F(PublishedJavino, an_action_that_the_sketch_does_not_know_is_an_error_and_calls_nothing) {
  javino.act["lampOn"] = lampOn;
  javino.act["forgotten"];
  for (const char *action : {"lampO", "lampOnn", "fly", "forgotten"}) {
    EXPECT_EQ(Status::ACTION_FAILED, act(action)) << action;
  }
  EXPECT_FALSE(lampIsOn);
  EXPECT_FALSE(javino.availableMsg()) << "it is for no one else either";
}

TEST_F(PublishedJavino, more_actions_than_there_are_places_leave_the_others_as_they_are) {
  Texts names;
  for (int i = 0; i <= javinolib::config::ACTIONS; i++) names.push_back("action" + std::to_string(i));
  for (const std::string &name : names) javino.act[name.c_str()] = lampOn;
  EXPECT_EQ(Status::OK, act(names.front()));
  EXPECT_EQ(Status::OK, act(names.back()));
  EXPECT_EQ(Status::ACTION_FAILED, act(names[names.size() - 2]));
}

TEST_F(PublishedJavino, tells_what_the_sketch_s_function_adds_whenever_that_changes) {
  static Javino *sketch;
  sketch = &javino;
  javino.perceive([] {
    calls++;
    sketch->addPercept(lampIsOn ? "led(on)" : "led(off)");
    sketch->addPercept("level(" + String(0.5) + ")");
  });
  EXPECT_EQ(0, calls) << "no agent wants percepts";
  poll();
  EXPECT_EQ((Texts{"led(off)", "level(0.50)"}), told());
  poll();
  now += 20;
  javino.run();
  EXPECT_EQ(2, calls);
  EXPECT_FALSE(answered()) << "nothing has changed";
  lampIsOn = true;
  now += 20;
  javino.run();
  EXPECT_EQ((Texts{"led(on)", "level(0.50)"}), told());
  EXPECT_FALSE(javino.availableMsg()) << "the function tells them";
}

TEST_F(PublishedJavino, a_sketch_without_functions_is_asked_for_percepts_while_an_agent_waits) {
  EXPECT_FALSE(javino.availableMsg());
  poll();
  told();
  poll();
  now = 50;
  ASSERT_TRUE(javino.availableMsg());
  EXPECT_TRUE(javino.requestPercepts());
  EXPECT_FALSE(javino.requestAction("lampOn"));
  EXPECT_STREQ("getPercepts", javino.getMsg().c_str());
  javino.addPercept("forgotten");
  javino.clearPercepts();
  javino.addPercept("led(on)");
  javino.addPercept("door(shut)");
  javino.sendPercepts();
  EXPECT_FALSE(javino.availableMsg()) << "it is asked every 20 ms";
  now += 20;
  javino.readSerial();
  EXPECT_EQ((Texts{"led(on)", "door(shut)"}), told());
  now += 20;
  poll();
  EXPECT_TRUE(javino.availableMsg());
}

TEST_F(PublishedJavino, a_sketch_without_functions_gets_each_action_once) {
  EXPECT_EQ(Status::OK, act("lampOn"));
  EXPECT_EQ(Status::ACTION_FAILED, act("lampOff")) << "the sketch has not taken the one before";
  ASSERT_TRUE(javino.availableMsg());
  EXPECT_TRUE(javino.requestAction("lampOn"));
  EXPECT_FALSE(javino.requestPercepts());
  EXPECT_STREQ("lampOn", javino.getMsg().c_str());
  EXPECT_FALSE(javino.availableMsg());
  EXPECT_EQ(Status::OK, act("lampOff"));
  EXPECT_TRUE(javino.availableMsg());
  EXPECT_TRUE(javino.requestAction("lampOff"));
}

TEST_F(PublishedJavino, what_a_sketch_sends_outside_of_a_request_are_its_percepts_from_then_on) {
  javino.sendMsg("led(on);door(shut);");
  poll();
  EXPECT_EQ((Texts{"led(on)", "door(shut)"}), told());
  poll();
  javino.sendMsg("door(open)");
  now += 20;
  javino.run();
  EXPECT_EQ(Texts{"door(open)"}, told());
}

TEST_F(FirstJavino, a_sketch_opens_the_board_by_asking_for_a_message) {
  EXPECT_CALL(line.serial, begin(115200)).Times(1);
  EXPECT_FALSE(javino.availablemsg());
  EXPECT_FALSE(javino.availablemsg());
}

TEST_F(FirstJavino, its_sketches_get_actions_and_tell_percepts) {
  EXPECT_FALSE(javino.availablemsg());
  send({'H', 1});
  EXPECT_FALSE(javino.availablemsg());
  send(bytesOf("AlampOn"));
  ASSERT_TRUE(javino.availablemsg());
  EXPECT_TRUE(javino.getmsg() == "lampOn");
  poll();
  told();
  poll();
  now = 50;
  ASSERT_TRUE(javino.availablemsg());
  EXPECT_TRUE(javino.getmsg() == "getPercepts");
  javino.sendmsg("led(on);door(shut);");
  now += 20;
  EXPECT_FALSE(javino.availablemsg());
  EXPECT_EQ((Texts{"led(on)", "door(shut)"}), told());
}
