// SPDX-License-Identifier: GPL-3.0-or-later
// The effects of commands on a run, and the errors of those that are wrong.
#include "support.h"

static const char CAR[] = R"({"boards":[
    {"name":"car","firmware":"@sensors","port":"car","sensors":[
      {"type":"hc-sr04","trigger":22,"echo":2,"distance":[[0,100]]},{"type":"ldr","pin":"A0","light":"world"},
      {"type":"digital","pin":40,"level":[[0,0]]}]},
    {"name":"bare","firmware":"@blink"}],"world":{"light":321,"obstacles":[{"name":"rock","position":[1,2],"radius":1}]}})";

TEST(CommandLine, each_mistake_gets_a_line_that_helps) {
  static const struct {
    const char *line, *error;
  } CASES[] = {
      {"", "column 0: '[' or '{' expected near end of file"},
      {"reset", "column 5: '[' or '{' expected near 'reset'"},
      {"{\"do\":\"reset\"} x", "column 16: end of file expected near 'x'"},
      {"\xff", "column 0: unable to decode byte 0xff"},
      {"[]", "the object: expected an object { … }, found []"},
      {"{}", "do: is missing; expected a command, for example \"reset\""},
      {R"({"do":5})",
       "do: expected reset, unplug, plug, power-cut, jam, move, obstacle, light, sensor, radio, speed, send, "
       "transition, found 5"},
      {R"({"do":"rest"})", "do: unknown value \"rest\"; did you mean \"reset\"?"},
      {R"({"do":"reset","do":"plug"})", "column 18: duplicate object key near '\"do\"'"},
      {R"({"do":"reset"})", "board: is missing; expected the name of one of the boards"},
      {R"({"do":"reset","board":"cart"})", "board: expected the name of one of the boards, found \"cart\""},
      {R"({"do":"reset","board":"car","t":1})", "the object: unknown key \"t\"; expected one of: do, board"},
      {R"({"do":"unplug","board":"bare"})", "board: \"bare\" has no \"port\" to unplug"},
      {R"({"do":"power-cut","board":"car"})", "duration: is missing; expected a number of seconds"},
      {R"({"do":"jam","duration":-1})", "duration: expected a number from 0 to 1e+09, found -1"},
      {R"({"do":"move","board":"car"})", "position: is missing; expected a position [x, y] in metres"},
      {R"({"do":"move","board":"car","position":[1,2],"heading":"north"})",
       "heading: expected a number from -360 to 360, found \"north\""},
      {R"({"do":"obstacle","position":[1,2],"radius":1})", "name: is missing; expected a text in quotes"},
      {R"({"do":"obstacle","name":"x","position":[1,2]})", "radius: is missing; expected a number of metres"},
      {R"({"do":"obstacle","name":"x","position":[1,2],"radius":0})",
       "radius: expected a number from 0.01 to 1000, found 0"},
      {R"({"do":"obstacle","name":"x","remove":false})", "remove: expected true, found false"},
      {R"({"do":"obstacle","name":"none","remove":true})", "there is no obstacle of this name"},
      {R"({"do":"light","value":1024})", "value: expected a number from 0 to 1023, found 1024"},
      {R"({"do":"light"})", "value: is missing; expected a number from 0 to 1023"},
      {R"({"do":"sensor","board":"car","pin":"A1","value":1})",
       "pin: expected the pin of a sensor of this board (the echo pin of an hc-sr04), found \"A1\""},
      {R"({"do":"sensor","board":"car","pin":"A0","value":1024})",
       "value: expected a number from 0 to 1023, found 1024"},
      {R"({"do":"sensor","board":"car","pin":40,"value":2})", "value: expected a number from 0 to 1, found 2"},
      {R"({"do":"sensor","board":"car","pin":2})", "value: is missing; expected a number from 0 to 10000"},
      {R"({"do":"radio","bitErrorRate":2})", "bitErrorRate: expected a number from 0 to 1, found 2"},
      {R"({"do":"speed","value":101})", "value: expected a number from 0 to 100, found 101"},
      {R"({"do":"speed","value":0.0009765625})",
       "value: expected 0, which pauses, or 0.001 to 100, found 0.0009765625"},
      {R"({"do":"send","payload":"00"})", "position: is missing; expected a position [x, y] in metres"},
      {R"({"do":"send","position":[0,0]})", "payload: is missing; expected 1 to 77 bytes in hexadecimal digits"},
      {R"({"do":"send","position":[0,0],"payload":"0"})",
       "payload: expected 1 to 77 bytes in hexadecimal digits, found \"0\""},
      {R"({"do":"send","position":[0,0],"payload":"0g"})",
       "payload: expected 1 to 77 bytes in hexadecimal digits, found \"0g\""},
      {R"({"do":"send","position":[0,0],"payload":"00","flip":8})",
       "flip: expected the number of a bit of the payload, 0 to 7"},
      {R"({"do":"send","position":[0,0],"payload":"00","hops":4})",
       "hops: expected the number of hops behind the packet, 0 to 3"},
      {R"({"do":"send","position":[0,0],"payload":"00","hops":"1"})",
       "hops: expected the number of hops behind the packet, 0 to 3"},
      {R"({"do":"send","position":[0,0],"payload":"00","distance":4})",
       "distance: expected the distance that the packet tells, 0 to 3"},
      {R"({"do":"transition","machine":"arrival","host":"SUBB","peer":"SUSS","id":"7"})",
       "state: is missing; expected a text in quotes"},
      {R"({"do":"transition","machine":7})", "machine: expected a text in quotes, found 7"},
  };
  Scratch scratch;
  Emulation run(scratch, CAR);
  for (const auto &c : CASES) EXPECT_EQ(run.command(c.line), "command: " + std::string(c.error)) << c.line;
  EXPECT_TRUE(run.events("command").empty());
}

TEST(CommandLine, damaged_ones_never_crash) {
  Scratch scratch;
  Emulation run(scratch, CAR);
  for (std::string good : {R"({"do":"send","position":[0,0],"payload":"00ff","flip":3})",
                           R"({"do":"sensor","board":"car","pin":"A0","value":null})",
                           R"({"do":"obstacle","name":"x","position":[1,2],"radius":1})"}) {
    for (size_t i = 0; i < good.size(); i++) {
      EXPECT_NE(run.command(good.substr(0, i)), "") << i;
      for (char c : {'[', '{', '0', '"', 'n', '\0', '\xff'}) {
        std::string changed = good;
        changed[i] = c;
        run.command(changed);  // may be good still; must not crash
      }
    }
  }
  run.run_until(0.01);
}

TEST(EmulationCommand, is_in_the_trace_as_it_was_given_with_its_cycle) {
  Scratch scratch;
  Emulation run(scratch, CAR);
  run.run_until(0.1);
  EXPECT_EQ(run.command(R"({"do":"reset","board":"car"})"), "");
  EXPECT_EQ(run.command(R"( {"do":"radio", "bitErrorRate":0.1,"range":50})"), "");
  std::string trace = run.trace_text();
  EXPECT_NE(trace.find(R"({"t":0.100000,"board":"car","event":"command","cycle":1600000,"do":"reset"})"
                       "\n{\"t\":0.1"),
            std::string::npos)
      << trace;
  EXPECT_NE(
      trace.find(R"({"t":0.100000,"event":"command","cycle":1600000,"do":"radio","bitErrorRate":0.1,"range":50})"),
      std::string::npos)
      << trace;
  EXPECT_EQ(run.events("car", "reset").size(), 2u);
}

TEST(EmulationCommand, what_a_host_tells_of_itself_is_in_the_trace_only) {
  Scratch scratch;
  Emulation run(scratch, CAR);
  std::string told = R"("machine":"arrival","host":"SUBB","peer":"SUSS","id":"7","state":"here"})";
  EXPECT_EQ(run.command(R"({"do":"transition",)" + told), "");
  EXPECT_NE(run.trace_text().find(R"("event":"transition",)" + told + "\n"), std::string::npos) << run.trace_text();
  EXPECT_TRUE(run.events("command").empty());
}

TEST(EmulationCommand, faults_come_at_once) {
  Scratch scratch;
  Emulation run(scratch, CAR);
  run.run_until(0.1);
  EXPECT_EQ(run.command(R"({"do":"unplug","board":"car"})"), "");
  EXPECT_FALSE(exists(scratch.path("car")));
  EXPECT_EQ(run.command(R"({"do":"plug","board":"car"})"), "");
  EXPECT_TRUE(exists(scratch.path("car")));
  EXPECT_EQ(run.command(R"({"do":"power-cut","board":"car","duration":0.1})"), "");
  EXPECT_FALSE(exists(scratch.path("car")));
  run.run_until(0.3);
  EXPECT_TRUE(exists(scratch.path("car")));
  EXPECT_EQ(run.events("car", "fault").size(), 3u);
  EXPECT_NEAR(run.events("car", "reset").at(1).t, 0.2, 0.001);
}

TEST(EmulationCommand, jams_are_as_many_as_there_is_room_for) {
  Scratch scratch;
  Emulation run(scratch, CAR);
  for (int i = 0; i < 61; i++) EXPECT_EQ(run.command(R"({"do":"jam","duration":0.1})"), "") << i;
  EXPECT_EQ(run.command(R"({"do":"jam","duration":0.1})"),
            "command: too many jams at one time; wait until one has ended");
  run.run_until(0.2);
  EXPECT_EQ(run.command(R"({"do":"jam","duration":0.1,"position":[1,1]})"), "");
  EXPECT_EQ(run.events("fault").size(), 62u);
}

// The last line that the program has printed: centimetres, light, button.
static std::string reading(Emulation &run, double until) {
  run.run_until(until);
  auto lines = run.events("car", "uart");
  return lines.empty() ? "" : lines.back().text("line");
}

TEST(EmulationCommand, sensors_measure_what_they_are_told_until_that_ends) {
  Scratch scratch;
  std::string car = CAR;
  car.replace(car.find(R"("port":"car",)"), 13, "");
  Emulation run(scratch, car);
  EXPECT_EQ(reading(run, 0.55), "100 321 0");
  EXPECT_EQ(run.command(R"({"do":"sensor","board":"car","pin":2,"value":50})"), "");
  EXPECT_EQ(run.command(R"({"do":"sensor","board":"car","pin":"A0","value":7})"), "");
  EXPECT_EQ(run.command(R"({"do":"sensor","board":"car","pin":40,"value":1})"), "");
  EXPECT_EQ(reading(run, 1), "50 7 1");
  EXPECT_EQ(run.command(R"({"do":"light","value":400})"), "");
  EXPECT_EQ(reading(run, 1.4), "50 7 1");
  EXPECT_EQ(run.command(R"({"do":"sensor","board":"car","pin":2,"value":null})"), "");
  EXPECT_EQ(run.command(R"({"do":"sensor","board":"car","pin":"A0","value":null})"), "");
  EXPECT_EQ(run.command(R"({"do":"sensor","board":"car","pin":40,"value":null})"), "");
  EXPECT_EQ(reading(run, 1.8), "100 400 0");
}

TEST(EmulationCommand, the_air_changes_by_what_is_given_and_stays_as_it_is_else) {
  Scratch scratch;
  Emulation run(scratch, R"({"radio":{"bitErrorRate":0.25,"capture":6},"boards":[{"name":"a","firmware":"@halt"}]})");
  run.run_until(0.1);
  EXPECT_EQ(run.command(R"({"do":"radio","bursts":{"rate":0.01},"noise":{"edges":100,"after":0}})"), "");
  EXPECT_EQ(run.command(R"({"do":"radio","errorsByDistance":[[5,0.5]],"shadowing":3})"), "");
  EXPECT_EQ(run.command(R"({"do":"radio","bursts":{"rate":1}})"),
            "command: bursts.rate: expected less than rateWithin, found 1");
  const radio_config &radio = run.e.air.radio;
  EXPECT_EQ(radio.bit_rate, 2000);
  EXPECT_EQ(radio.range_m, 100);
  EXPECT_EQ(radio.bit_error_rate, 0.25);
  EXPECT_EQ(radio.capture_db, 6);
  EXPECT_EQ(radio.bursts.rate, 0.01);
  EXPECT_EQ(radio.noise.edges_per_s, 100);
  EXPECT_EQ(radio.distance_rate_count, 1u);
  EXPECT_EQ(radio.shadowing_db, 3);
  EXPECT_EQ(run.command(R"({"do":"radio","errorsByDistance":[],"noise":{"edges":0},"bursts":{"rate":0}})"), "");
  EXPECT_EQ(radio.distance_rate_count, 0u);
  EXPECT_EQ(radio.noise.edges_per_s, 0);
  EXPECT_EQ(radio.bursts.rate, 0);
}

static const char PAIR[] = R"({"boards":[{"name":"sender","firmware":"@rf_send","position":[0,0]},
    {"name":"mirror","firmware":"@rf_mirror","position":[30,40]}]})";

TEST(EmulationCommand, who_is_moved_out_of_range_hears_nothing_until_it_is_back) {
  Scratch scratch;
  Emulation run(scratch, PAIR);
  run.run_until(0.4);
  EXPECT_EQ(run.events("rf-rx").size(), 1u);
  EXPECT_EQ(run.command(R"({"do":"move","board":"mirror","position":[300,40]})"), "");
  run.run_until(0.8);
  EXPECT_EQ(run.events("rf-tx").size(), 2u);
  EXPECT_EQ(run.events("rf-rx").size(), 1u);
  EXPECT_EQ(run.command(R"({"do":"radio","range":400})"), "");
  run.run_until(1.2);
  EXPECT_EQ(run.events("rf-rx").size(), 2u);
  EXPECT_EQ(run.command(R"({"do":"radio","bitErrorRate":0.5})"), "");
  run.run_until(1.6);
  EXPECT_EQ(run.events("rf-damaged").size(), 1u);
  EXPECT_EQ(run.command(R"({"do":"radio","bitErrorRate":0})"), "");
  run.run_until(2);
  EXPECT_EQ(run.events("rf-rx").size(), 3u);
  auto places = run.events("mirror", "place");
  ASSERT_EQ(places.size(), 1u);
  EXPECT_EQ(json_number_value(json_array_get(json_object_get(places[0].fields, "position"), 0)), 300);
}
