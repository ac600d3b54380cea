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

// Its getMsg() gives the bytes behind preamble and length, whatever they are; it compares them whole.
TEST_F(PublishedJavino, a_sketch_gets_each_text_as_the_published_library_gives_it) {
  const struct {
    std::string text;
    bool isLampOn;
    bool asksPercepts;
  } rows[] = {
      {"lampOn", true, false},
      {"getPercepts", false, true},
      {"speed(80)", false, false},
      {"speed( 80 )", false, false},
      {"drive(10,-20)", false, false},
      {"\"ARGO online!\"", false, false},
      {"ARGO online!", false, false},
      {"\"lampOn\"", false, false},
      {"lampOn()", false, false},
      {"lampOn(now)", false, false},
      {"lampOn ", false, false},
      {" lampOn", false, false},
      {"LampOn", false, false},
      {"getPercepts()", false, false},
      {"say(\"hello, world\")", false, false},
      {"say(\"a \\\"b\\\"\")", false, false},
      {"say(hello)[source(bob)]", false, false},
      {"lampOn;lampOff", false, false},
      {"open(", false, false},
      {"open)", false, false},
      {"\"open", false, false},
      {"\"", false, false},
      {"-3.5", false, false},
      {"[a,b,[c]]", false, false},
      {"{ +!go <- run }", false, false},
      {"X", false, false},
      {"_", false, false},
      {"temperatura da água: 20 °C", false, false},
      {"fffe05hello", false, false},
      {"line 1\nline 2\t", false, false},
      {"%$#@!?", false, false},
      {std::string(javinolib::config::BOARD_MESSAGE - 1, 'x'), false, false},
  };
  for (const auto &row : rows) {
    EXPECT_EQ(Status::OK, act(row.text)) << row.text;
    EXPECT_TRUE(javino.availableMsg()) << row.text;
    EXPECT_EQ(row.text, javino.getMsg().c_str());
    EXPECT_EQ(row.isLampOn, javino.requestAction("lampOn")) << row.text;
    EXPECT_EQ(row.asksPercepts, javino.requestPercepts()) << row.text;
    EXPECT_FALSE(javino.availableMsg()) << row.text;
    EXPECT_EQ(row.text, javino.getMsg().c_str()) << "until the next one";
  }
}

TEST_F(PublishedJavino, a_function_is_called_for_a_whole_text_and_may_ask_for_it) {
  static Javino *sketch;
  static std::string called;
  sketch = &javino;
  javino.act["speed(80)"] = [] { called = "80 of "; };
  javino.act["speed"] = [] { called = "any of "; };
  javino.act["\"hi\""] = [] { called = "hi of "; };
  for (const auto &name : {"speed(80)", "speed", "\"hi\""}) {
    const Javino::Function function = javino.act[name];
    called.clear();
    EXPECT_EQ(Status::OK, act(name));
    const std::string by = called;
    called.clear();
    function();
    EXPECT_EQ(called, by) << name;
    EXPECT_STREQ(name, javino.getMsg().c_str());
  }
  EXPECT_EQ(Status::OK, act("speed(81)")) << "what the published library would crash at";
  EXPECT_EQ("any of ", called);
  EXPECT_STREQ("speed(81)", sketch->getMsg().c_str());
  EXPECT_EQ(Status::ACTION_FAILED, act("\"ho\""));
  EXPECT_EQ(Status::BAD_ARGUMENT, act(""));
}

// Its host parts them at each semicolon.
TEST_F(PublishedJavino, percepts_are_those_that_the_published_host_finds) {
  const struct {
    void (*tell)(Javino &);
    Texts percepts;
  } rows[] = {
      {[](Javino &j) { j.addPercept("led(on)"), j.addPercept("device(lamp)"), j.sendPercepts(); },
       {"led(on)", "device(lamp)"}},
      {[](Javino &j) { j.addPercept("led(on);device(lamp)"), j.sendPercepts(); }, {"led(on)", "device(lamp)"}},
      {[](Javino &j) { j.addPercept("led(on);"), j.sendPercepts(); }, {"led(on)"}},
      {[](Javino &j) { j.sendMsg("led(on);device(lamp);"); }, {"led(on)", "device(lamp)"}},
      {[](Javino &j) { j.sendMsg("led(on);device(lamp)"); }, {"led(on)", "device(lamp)"}},
      {[](Javino &j) { j.sendMsg("led(on)"); }, {"led(on)"}},
      {[](Javino &j) { j.sendMsg("says(\"a, b\");at(3,[x,y])"); }, {"says(\"a, b\")", "at(3,[x,y])"}},
      {[](Javino &j) { j.addPercept("old"), j.clearPercepts(), j.addPercept("new"), j.sendPercepts(); }, {"new"}},
      {[](Javino &j) { j.addPercept("kept"), j.sendMsg("now"); }, {"now"}},
      {[](Javino &j) { j.addPercept("and"), j.sendPercepts(); }, {"kept", "and"}},
      {[](Javino &j) { j.sendPercepts(); }, {}},
  };
  for (const auto &row : rows) {
    row.tell(javino);
    ask({'H', 1});  // which it is told in any case after a hello
    poll();
    EXPECT_EQ(row.percepts, told());
  }
}

TEST_F(PublishedJavino, a_semicolon_within_a_string_parts_nothing) {
  javino.sendMsg("says(\"a;b\");says(\"c\\\";d\");led(on)");
  poll();
  EXPECT_EQ((Texts{"says(\"a;b\")", "says(\"c\\\";d\")", "led(on)"}), told());
  javino.sendMsg(R"(path("C:\\");says("\\\";e");led(off))");
  ask({'H', 1});
  poll();
  EXPECT_EQ((Texts{R"(path("C:\\"))", R"(says("\\\";e"))", "led(off)"}), told());
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
