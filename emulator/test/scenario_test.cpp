// SPDX-License-Identifier: GPL-3.0-or-later
#include "support.h"

#include <sys/stat.h>

#include <cmath>
#include <cstring>

extern "C" {
#include "propagation.h"
#include "scenario_radio.h"
}

// Loads a scenario; `#boards` stands for a good list of boards. Returns the error, "" if none.
static std::string load(const Scratch &scratch, std::string json, std::vector<const char *> overrides = {},
                        scenario *kept = nullptr) {
  static const std::string BOARDS =
      R"("boards":[{"name":"bus","firmware":"bus.elf","port":"ports/bus"},{"name":"car","firmware":"bus.elf"}])";
  scratch.write("bus.elf", "");
  if (json.find("#boards") != std::string::npos) json.replace(json.find("#boards"), 7, BOARDS);
  std::string path = scratch.write("s.json", json);
  scenario loaded;
  scenario_context context = {"run", overrides.data(), overrides.size()};
  char error[512];
  int result = scenario_load(&loaded, path.c_str(), &context, error, sizeof error);
  EXPECT_EQ(result == 0, error[0] == '\0');
  if (kept)
    *kept = loaded;
  else
    scenario_release(&loaded);
  std::string text = error;
  return text.compare(0, path.size(), path) == 0 ? text.substr(path.size()) : text;
}

static std::string with_sensor(const std::string &sensor) {
  return R"({"boards":[{"name":"bus","firmware":"bus.elf","sensors":[)" + sensor + "]}]}";
}

TEST(Scenario, a_full_one_is_read) {
  Scratch scratch;
  scenario s;
  ASSERT_EQ(load(scratch, R"({
        "radio": {"bitRate": 1000, "range": 50.5, "bitErrorRate": 0.001},
        "boards": [
          {"name": "bus", "firmware": "bus.elf", "port": "ports/bus", "eeprom": "/var/bus.bin",
           "position": [1, -2.5], "resetOnOpen": false, "bridge": {"latency": 16}, "txPin": 7, "rxPin": "A3",
           "sensors": [
             {"type": "hc-sr04", "trigger": 22, "echo": 2, "distance": [[0, 200], [8, 15]],
              "after": {"pin": 5, "level": 0}},
             {"type": "ldr", "pin": "A0", "light": [[0, 800]]},
             {"type": "digital", "pin": 40, "level": [[0, 0], [1.5, 1]]}],
           "watch": [{"pin": 5, "name": "motorLeft"}]}],
        "faults": [{"t": 9, "do": "jam", "duration": 1.0, "position": [3, 4]},
                   {"t": 5.0, "board": "bus", "do": "reset"},
                   {"t": 6, "board": "bus", "do": "power-cut", "duration": 0.2, "eepromWrites": 3,
                    "after": {"pin": 5, "level": 0}}]})",
                 {}, &s),
            "");
  EXPECT_EQ(s.radio.bit_rate, 1000);
  EXPECT_EQ(s.radio.range_m, 50.5);
  EXPECT_EQ(s.radio.bit_error_rate, 0.001);
  const board_config &bus = s.boards[0];
  EXPECT_STREQ(bus.firmware, scratch.path("bus.elf").c_str());
  EXPECT_STREQ(bus.port, "run/ports/bus");
  EXPECT_STREQ(bus.eeprom, "/var/bus.bin");
  EXPECT_EQ(bus.y_m, -2.5);
  EXPECT_FALSE(bus.reset_on_open);
  EXPECT_EQ(bus.bridge_latency_ms, 16);
  EXPECT_EQ(bus.tx_pin, 7);
  EXPECT_EQ(bus.rx_pin, 57);
  ASSERT_EQ(bus.sensor_count, 3u);
  EXPECT_EQ(bus.sensors[0].after_pin, 5);
  EXPECT_EQ(bus.sensors[0].after_level, 0);
  EXPECT_EQ(bus.sensors[0].values.points[1].value, 15);
  EXPECT_EQ(bus.sensors[1].pin, 54);
  EXPECT_EQ(bus.sensors[1].after_pin, -1);
  EXPECT_EQ(bus.sensors[2].kind, SENSOR_DIGITAL);
  EXPECT_STREQ(bus.watches[0].name, "motorLeft");
  EXPECT_EQ(s.faults[0].kind, FAULT_RESET);  // in order of time
  EXPECT_EQ(s.faults[0].after_pin, -1);
  EXPECT_EQ(s.faults[1].kind, FAULT_POWER_CUT);
  EXPECT_EQ(s.faults[1].duration_s, 0.2);
  EXPECT_EQ(s.faults[1].eeprom_writes, 3u);
  EXPECT_EQ(s.faults[1].after_pin, 5);
  EXPECT_EQ(s.faults[1].after_level, 0);
  EXPECT_EQ(s.faults[2].y_m, 4);
  EXPECT_EQ(s.faults[2].after_pin, -1);
  scenario_release(&s);
}

TEST(Scenario, all_of_the_air_is_read_and_written_as_it_is_read_again) {
  Scratch scratch;
  scenario s, again;
  ASSERT_EQ(
      load(scratch, R"({"radio":{"range":80,"bitErrorRate":0.001,"bursts":{"rate":0.02,"length":50,"rateWithin":0.5},
                "errorsByDistance":[[10,0],[50,0.01],[90,0.3]],"shadowing":5,"noise":{"edges":3000,"after":0.1},
                "capture":6},#boards})",
           {}, &s),
      "");
  EXPECT_EQ(s.radio.bursts.rate, 0.02);
  EXPECT_EQ(s.radio.bursts.length_bits, 50);
  EXPECT_EQ(s.radio.bursts.rate_within, 0.5);
  ASSERT_EQ(s.radio.distance_rate_count, 3u);
  EXPECT_EQ(s.radio.distance_rates[1].metres, 50);
  EXPECT_EQ(s.radio.distance_rates[1].rate, 0.01);
  EXPECT_EQ(s.radio.shadowing_db, 5);
  EXPECT_EQ(s.radio.noise.edges_per_s, 3000);
  EXPECT_EQ(s.radio.noise.after_s, 0.1);
  EXPECT_EQ(s.radio.capture_db, 6);
  json_t *written = radio_config_json(&s.radio);
  char *text = json_dumps(written, 0);
  ASSERT_EQ(load(scratch, R"({"radio":)" + std::string(text) + ",#boards}", {}, &again), "");
  EXPECT_EQ(memcmp(&again.radio, &s.radio, sizeof s.radio), 0);
  free(text);
  json_decref(written);
  scenario_release(&s);
  scenario_release(&again);
}

TEST(Scenario, one_word_brings_a_path_loss_with_its_range_and_shadowing) {
  Scratch scratch;
  scenario s;
  ASSERT_EQ(load(scratch, R"({"radio":{"errorsByDistance":"outdoors"},#boards})", {}, &s), "");
  EXPECT_EQ(s.radio.range_m, 200);
  EXPECT_EQ(s.radio.shadowing_db, 4);
  for (double metres : {80.0, 100.0, 105.0, 115.0, 140.0, 175.0, 200.0}) {
    double expected = 0.5 * std::exp(-std::log(500) * std::pow(100 / metres, 3));
    EXPECT_NEAR(propagation_error_rate(&s.radio, metres) / expected, 1, 0.2) << metres;
  }
  EXPECT_EQ(propagation_error_rate(&s.radio, 50), 0);
  scenario_release(&s);
  ASSERT_EQ(load(scratch, R"({"radio":{"errorsByDistance":"outdoors","shadowing":0,"range":150},#boards})", {}, &s),
            "");
  EXPECT_EQ(s.radio.range_m, 150);
  EXPECT_EQ(s.radio.shadowing_db, 0);
  scenario_release(&s);
}

TEST(Scenario, bursts_and_noise_have_defaults) {
  Scratch scratch;
  scenario s;
  ASSERT_EQ(load(scratch, R"({"radio":{"bursts":{"rate":0.01},"noise":{}},#boards})", {}, &s), "");
  EXPECT_EQ(s.radio.bursts.length_bits, 30);
  EXPECT_EQ(s.radio.bursts.rate_within, 0.25);
  EXPECT_EQ(s.radio.noise.edges_per_s, 2000);
  EXPECT_EQ(s.radio.noise.after_s, 0.2);
  scenario_release(&s);
}

TEST(Scenario, a_board_has_a_clock_error_and_a_path) {
  Scratch scratch;
  scenario s;
  ASSERT_EQ(load(scratch, R"({"boards":[{"name":"b","firmware":"bus.elf","clockError":-3000,
                "path":[[1,[5,6]],[2.5,[7,-8]]]}]})",
                 {}, &s),
            "");
  EXPECT_EQ(s.boards[0].clock_error_ppm, -3000);
  EXPECT_EQ(s.boards[0].x_m, 5);
  EXPECT_EQ(s.boards[0].y_m, 6);
  ASSERT_EQ(s.boards[0].path_x.count, 2u);
  EXPECT_EQ(s.boards[0].path_y.points[1].t_s, 2.5);
  EXPECT_EQ(s.boards[0].path_y.points[1].value, -8);
  scenario_release(&s);
}

TEST(Scenario, a_short_one_has_the_defaults) {
  Scratch scratch;
  scenario s;
  ASSERT_EQ(load(scratch, "{#boards}", {}, &s), "");
  EXPECT_EQ(s.radio.bit_rate, 2000);
  EXPECT_EQ(s.radio.range_m, 100);
  EXPECT_EQ(s.radio.bit_error_rate, 0);
  EXPECT_EQ(s.radio.bursts.rate, 0);
  EXPECT_EQ(s.radio.distance_rate_count, 0u);
  EXPECT_EQ(s.radio.shadowing_db, 0);
  EXPECT_EQ(s.radio.noise.edges_per_s, 0);
  EXPECT_EQ(s.radio.capture_db, 0);
  EXPECT_EQ(s.boards[1].clock_error_ppm, 0);
  EXPECT_EQ(s.boards[1].path_x.count, 0u);
  EXPECT_EQ(s.boards[1].model, &MEGA);
  EXPECT_EQ(s.boards[1].port, nullptr);
  EXPECT_TRUE(s.boards[0].reset_on_open);
  EXPECT_EQ(s.boards[0].bridge_latency_ms, 0);
  EXPECT_EQ(s.boards[0].tx_pin, 12);
  EXPECT_EQ(s.boards[0].rx_pin, 11);
  EXPECT_EQ(s.fault_count, 0u);
  scenario_release(&s);
}

TEST(Scenario, each_mistake_gets_a_line_that_helps) {
  static const struct {
    const char *json, *error;
  } CASES[] = {
      {"{\n\"radio\": {,}}", ": line 2, column 11: string or '}' expected near ','"},
      {"[]", ": the whole file: expected an object { … }, found []"},
      {"{}", ": boards: is missing; expected a list of 1 to 48 boards"},
      {R"({"boards":[]})", ": boards: expected a list of 1 to 48 boards, found []"},
      {R"({"board":[]})", ": the whole file: unknown key \"board\"; did you mean \"boards\"?"},
      {R"({"weather":1})", ": the whole file: unknown key \"weather\"; expected one of: radio, boards, faults, world"},
      {R"({"radio":{"bitrate":2000},#boards})", ": radio: unknown key \"bitrate\"; did you mean \"bitRate\"?"},
      {R"({"radio":{"bitRate":"fast"},#boards})",
       ": radio.bitRate: expected a number from 100 to 10000, found \"fast\""},
      {R"({"radio":{"bitErrorRate":1.5},#boards})", ": radio.bitErrorRate: expected a number from 0 to 1, found 1.5"},
      {R"({"radio":{"bursts":{"length":30}},#boards})",
       ": radio.bursts.rate: is missing; expected the mean rate of errors, 0 to 1"},
      {R"({"radio":{"bursts":{"rate":0.25}},#boards})",
       ": radio.bursts.rate: expected less than rateWithin, found 0.25"},
      {R"({"radio":{"bursts":{"rate":0.1,"length":0.5}},#boards})",
       ": radio.bursts.length: expected a number from 1 to 1e+06, found 0.5"},
      {R"({"radio":{"bursts":0.01},#boards})", ": radio.bursts: expected an object { … }, found 0.01"},
      {R"({"radio":{"errorsByDistance":"indoors"},#boards})",
       ": radio.errorsByDistance: expected \"outdoors\", or a list of up to 16 points [[metres, rate], …], found "
       "\"indoors\""},
      {R"({"radio":{"errorsByDistance":[[1,0],[2,0],[3,0],[4,0],[5,0],[6,0],[7,0],[8,0],[9,0],[10,0],[11,0],[12,0],[13,0],[14,0],[15,0],[16,0],[17,0]]},#boards})",
       ": radio.errorsByDistance: expected \"outdoors\", or a list of up to 16 points [[metres, rate], …], found "
       "[[1,0],[2,0],[3,0],[4,0],[5,0],[6,0],[7,0],[8,0],[9,0],[10,0"},
      {R"({"radio":{"errorsByDistance":[[1]]},#boards})",
       ": radio.errorsByDistance[0]: expected a point [metres, rate], found [1]"},
      {R"({"radio":{"errorsByDistance":[[9,0],[9,1]]},#boards})",
       ": radio.errorsByDistance[1]: expected more metres than those of the point before, found [9,1]"},
      {R"({"radio":{"noise":{"edge":1}},#boards})", ": radio.noise: unknown key \"edge\"; did you mean \"edges\"?"},
      {R"({"radio":{"shadowing":-1},#boards})", ": radio.shadowing: expected a number from 0 to 20, found -1"},
      {R"({"radio":{"capture":"6 dB"},#boards})", ": radio.capture: expected a number from 0 to 60, found \"6 dB\""},
      {R"({"boards":[{"name":"b","firmware":"bus.elf","clockError":0.5}]})",
       ": boards[0].clockError: expected a whole number from -50000 to 50000, found 0.5"},
      {R"({"boards":[{"name":"b","firmware":"bus.elf","clockError":60000}]})",
       ": boards[0].clockError: expected a whole number from -50000 to 50000, found 60000"},
      {R"({"boards":[{"name":"b","firmware":"bus.elf","path":[]}]})",
       ": boards[0].path: expected a list of points [[seconds, [x, y]], …], found []"},
      {R"({"boards":[{"name":"b","firmware":"bus.elf","path":[[0,1]]}]})",
       ": boards[0].path[0][1]: expected a list [ … ], found 1"},
      {R"({"boards":[{"name":"b","firmware":"bus.elf","path":[[0,[1,1]],[0,[2,2]]]}]})",
       ": boards[0].path[1]: expected a later time than that of the point before, found [0,[2,2]]"},
      {R"({"boards":[{"name":"b","firmware":"bus.elf","path":[[0,[1,1]]],"position":[1,1]}]})",
       ": boards[0].position: the path says where the board is; expected one of the two"},
      {R"({"boards":[{"name":"b","firmware":"bus.elf","path":[[0,[1,1]]],"vehicle":{"forward":[5,7],"backward":[6,8]}}]})",
       ": boards[0].path: the board's vehicle drives where it will; expected one of the two"},
      {R"({"boards":[{"firmware":"bus.elf"}]})", ": boards[0].name: is missing; expected a text in quotes"},
      {R"({"boards":[{"name":"b","firmware":"bus.elf","bootLoader":"/no/loader.hex"}]})",
       ": boards[0].bootLoader: cannot read /no/loader.hex (No such file or directory); install arduino-core-avr or "
       "correct the path"},
      {R"({"boards":[{"name":"b","firmware":"bus.elf","eprom":"x"}]})",
       ": boards[0]: unknown key \"eprom\"; did you mean \"eeprom\"?"},
      {R"({"boards":[{"name":"b","firmware":"bus.elf","txPin":70}]})",
       ": boards[0].txPin: expected a pin: 0…69 or \"A0\"…\"A15\", found 70"},
      {R"({"boards":[{"name":"b","firmware":"bus.elf","model":"unno"}]})",
       ": boards[0].model: unknown value \"unno\"; did you mean \"uno\"?"},
      {R"({"boards":[{"name":"b","firmware":"bus.elf","model":"uno","txPin":20}]})",
       ": boards[0].txPin: expected a pin: 0…19 or \"A0\"…\"A5\", found 20"},
      {R"({"boards":[{"name":"b","firmware":"bus.elf","txPin":11}]})",
       ": boards[0].rxPin: is missing; expected another pin than txPin"},
      {R"({"boards":[{"name":"b","firmware":"bus.elf","position":[1]}]})",
       ": boards[0].position: expected a position [x, y] in metres, found [1]"},
      {R"({"boards":[{"name":"b","firmware":"bus.elf","resetOnOpen":1}]})",
       ": boards[0].resetOnOpen: expected true or false, found 1"},
      {R"({"boards":[{"name":"b","firmware":"bus.elf","bridge":16}]})",
       ": boards[0].bridge: expected an object { … }, found 16"},
      {R"({"boards":[{"name":"b","firmware":"bus.elf","bridge":{"latence":16}}]})",
       ": boards[0].bridge: unknown key \"latence\"; did you mean \"latency\"?"},
      {R"({"boards":[{"name":"b","firmware":"bus.elf","bridge":{"latency":-1}}]})",
       ": boards[0].bridge.latency: expected a number from 0 to 255, found -1"},
      {R"({"boards":[{"name":"b","firmware":"bus.elf","bridge":{"latency":256}}]})",
       ": boards[0].bridge.latency: expected a number from 0 to 255, found 256"},
      {R"({"boards":[{"name":"b","firmware":"bus.elf","bridge":{"latency":"16"}}]})",
       ": boards[0].bridge.latency: expected a number from 0 to 255, found \"16\""},
      {R"({"boards":[{"name":"b","firmware":"bus.elf"},{"name":"b","firmware":"bus.elf"}]})",
       ": boards[1].name: is the same as that of boards[0]; expected one of its own"},
      {R"({"boards":[{"name":"a","firmware":"bus.elf","port":"p/a"},{"name":"b","firmware":"bus.elf","port":"./p//./a"}]})",
       ": boards[1].port: is the same as that of boards[0]; expected one of its own"},
      {R"({"boards":[{"name":"b","firmware":"bus.elf","watch":[{"pin":54,"name":"a"},{"pin":"A0","name":"b"}]}]})",
       ": boards[0].watch[1]: has the pin of watch[0]; expected one of its own"},
      {R"({"boards":[{"name":"b","firmware":"bus.elf","watch":[{"pin":1,"name":"a"},{"pin":2,"name":"a"}]}]})",
       ": boards[0].watch[1]: has the name of watch[0]; expected one of its own"},
      {R"({"boards":[{"name":"b","firmware":"bus.elf","sensors":[{"type":"digital","pin":"A0","level":[[0,1]]},{"type":"ldr","pin":54,"light":[[0,1]]}]}]})",
       ": boards[0].sensors[1]: has the pin of sensors[0]; expected one of its own"},
      {R"({#boards,"faults":[{"t":1,"do":"rest","board":"bus"}]})",
       ": faults[0].do: unknown value \"rest\"; did you mean \"reset\"?"},
      {R"({#boards,"faults":[{"t":1,"do":"reset","board":"buss"}]})",
       ": faults[0].board: expected the name of one of the boards, found \"buss\""},
      {R"({#boards,"faults":[{"t":1,"do":"unplug","board":"car"}]})",
       ": faults[0].board: \"car\" has no \"port\" to unplug"},
      {R"({#boards,"faults":[{"do":"reset","board":"bus"}]})",
       ": faults[0].t: is missing; expected a number of seconds"},
      {R"({#boards,"faults":[{"t":1,"do":"power-cut","board":"car"}]})",
       ": faults[0].duration: is missing; expected a number of seconds"},
      {R"({#boards,"faults":[{"t":1,"do":"power-cut","board":"car","duration":1,"eepromWrites":0}]})",
       ": faults[0].eepromWrites: expected a whole number from 1 to 1000000000, found 0"},
      {R"({#boards,"faults":[{"t":1,"do":"power-cut","board":"car","duration":1,"eepromWrites":1.5}]})",
       ": faults[0].eepromWrites: expected a whole number from 1 to 1000000000, found 1.5"},
      {R"({#boards,"faults":[{"t":1,"do":"reset","board":"car","eepromWrites":1}]})",
       ": faults[0]: unknown key \"eepromWrites\"; expected one of: t, do, board, after"},
      {R"({#boards,"faults":[{"t":1,"do":"reset","board":"car","after":{"level":1}}]})",
       ": faults[0].after.pin: is missing; expected a pin: 0…69 or \"A0\"…\"A15\""},
      {R"({#boards,"faults":[{"t":1,"do":"jam","duration":1,"after":{"pin":1}}]})",
       ": faults[0]: unknown key \"after\"; expected one of: t, do, duration, position"},
      {R"({#boards,"faults":[{"t":1,"do":"jam"}]})", ": faults[0].duration: is missing; expected a number of seconds"},
      {R"({#boards,"world":{"light":1024}})", ": world.light: expected a number from 0 to 1023, found 1024"},
      {R"({#boards,"world":{"obstacles":[{"name":"rock","radius":1}]}})",
       ": world.obstacles[0].position: is missing; expected a position [x, y] in metres"},
      {R"({#boards,"world":{"obstacles":[{"name":"a","position":[0,0],"radius":1},{"name":"a","position":[0,0],"radius":1}]}})",
       ": world.obstacles[1]: has the name of obstacles[0]; expected one of its own"},
      {R"({"boards":[{"name":"b","firmware":"bus.elf","vehicle":{"forward":[5,7]}}]})",
       ": boards[0].vehicle.backward: is missing; expected two pins [left, right]"},
      {R"({"boards":[{"name":"b","firmware":"bus.elf","vehicle":{"forward":[5,77],"backward":[6,8]}}]})",
       ": boards[0].vehicle.forward[1]: expected a pin: 0…69 or \"A0\"…\"A15\", found 77"},
      {R"({"boards":[{"name":"b","firmware":"bus.elf","sensors":[{"type":"hc-sr04","trigger":22,"echo":2,"distance":"world"}]}]})",
       ": boards[0].sensors[0]: a distance in the world needs a vehicle; expected a \"vehicle\" of the board, or a "
       "list of "
       "points"},
      {R"({"boards":[{"name":"injector","firmware":"bus.elf"}]})",
       ": boards[0].name: expected another name: the injector of the trace has this one, found \"injector\""},
      {R"({#boards,"faults":{}})", ": faults: expected a list [ … ], found {}"},
  };
  Scratch scratch;
  for (const auto &c : CASES) EXPECT_EQ(load(scratch, c.json), c.error) << c.json;
}

TEST(Scenario, each_mistake_in_a_sensor_gets_a_line_that_helps) {
  static const struct {
    const char *sensor, *error;
  } CASES[] = {
      {R"({"pin":1})", ".type: is missing; expected \"hc-sr04\", \"ldr\" or \"digital\""},
      {R"({"type":"hcsr04"})", ".type: unknown value \"hcsr04\"; did you mean \"hc-sr04\"?"},
      {R"({"type":"hc-sr04","triger":1})", ": unknown key \"triger\"; did you mean \"trigger\"?"},
      {R"({"type":"hc-sr04","echo":2,"distance":[[0,1]]})",
       ".trigger: is missing; expected a pin: 0…69 or \"A0\"…\"A15\""},
      {R"({"type":"ldr","pin":"B3","light":[[0,1]]})", ".pin: expected a pin: 0…69 or \"A0\"…\"A15\", found \"B3\""},
      {R"({"type":"ldr","pin":40,"light":[[0,1]]})", ".pin: expected an analog pin, \"A0\"…\"A7\", found 40"},
      {R"({"type":"ldr","pin":"A8","light":[[0,1]]})", ".pin: expected an analog pin, \"A0\"…\"A7\", found \"A8\""},
      {R"({"type":"ldr","pin":"A0"})",
       ".light: is missing; expected a list of points [[seconds, value], …], or \"world\""},
      {R"({"type":"ldr","pin":"A0","light":[0,1]})", ".light[0]: expected a point [seconds, value], found 0"},
      {R"({"type":"ldr","pin":"A0","light":[[0,2000]]})", ".light[0][1]: expected a number from 0 to 1023, found 2000"},
      {R"({"type":"ldr","pin":"A0","light":[[1,1],[1,2]]})",
       ".light[1]: expected a later time than that of the point before, found [1,2]"},
      {R"({"type":"ldr","pin":"A0","light":[[0,1]],"noise":-1})", ".noise: expected a number from 0 to 1023, found -1"},
      {R"({"type":"digital","pin":4,"level":[[0,1]],"after":{"level":1}})",
       ".after.pin: is missing; expected a pin: 0…69 or \"A0\"…\"A15\""},
  };
  Scratch scratch;
  for (const auto &c : CASES)
    EXPECT_EQ(load(scratch, with_sensor(c.sensor)), ": boards[0].sensors[0]" + std::string(c.error)) << c.sensor;
}

TEST(Scenario, there_are_48_boards_at_most) {
  Scratch scratch;
  std::string boards;
  auto add = [&boards](int n) { boards += R"({"firmware":"bus.elf","name":"b)" + std::to_string(n) + "\"}"; };
  for (int n = 1; n < 48; n++, boards += ',') add(n);
  add(48);
  EXPECT_EQ(load(scratch, "{\"boards\":[" + boards + "]}"), "");
  boards += ',';
  add(49);
  std::string error = load(scratch, "{\"boards\":[" + boards + "]}");
  EXPECT_EQ(error.find(": boards: expected a list of 1 to 48 boards, found [{"), 0u) << error;
}

TEST(Scenario, a_missing_file_is_named) {
  Scratch scratch;
  scenario s;
  scenario_context context = {".", nullptr, 0};
  char error[512];
  std::string path = scratch.path("none.json");
  EXPECT_EQ(scenario_load(&s, path.c_str(), &context, error, sizeof error), -1);
  EXPECT_EQ(error, path + ": cannot read the scenario: No such file or directory");
  scenario_release(&s);
  EXPECT_EQ(load(scratch, R"({"boards":[{"name":"b","firmware":"none.elf"}]})"),
            ": boards[0].firmware: cannot read " + scratch.path("none.elf") +
                " (No such file or directory); build the firmware or correct the path");
}

TEST(Scenario, overrides_are_checked_like_the_file) {
  Scratch scratch;
  scenario s;
  ASSERT_EQ(load(scratch, R"({"radio":{"range":5},#boards})", {"radio.range=7", "radio.bitErrorRate=0.25"}, &s), "");
  EXPECT_EQ(s.radio.range_m, 7);
  EXPECT_EQ(s.radio.bit_error_rate, 0.25);
  scenario_release(&s);
  EXPECT_EQ(load(scratch, "{#boards}", {"radio.rang=7"}), ": radio: unknown key \"rang\"; did you mean \"range\"?");
  EXPECT_EQ(load(scratch, "{#boards}", {"radio.bitErrorRate=2"}),
            ": radio.bitErrorRate: expected a number from 0 to 1, found 2");
  for (const char *bad : {"radio.range", "radio.range=far", "boards=1", "range=1", "=", ""})
    EXPECT_EQ(load(scratch, "{#boards}", {bad}),
              "--set " + std::string(bad) + ": expected radio.key=number, e.g. radio.bitErrorRate=0.001");
}

TEST(Scenario, damaged_files_are_refused_and_never_crash) {
  Scratch scratch;
  std::string good = R"({"radio":{"range":5,"bursts":{"rate":0.1},"errorsByDistance":[[1,0],[2,1]],"noise":{}},)"
                     R"("boards":[{"name":"b","firmware":"bus.elf","path":[[0,[1,2]],[1,[3,4]]],)"
                     R"("sensors":[{"type":"ldr","pin":"A0","light":[[0,800]]}],"watch":[{"pin":5,"name":"x"}]}],)"
                     R"("faults":[{"t":9,"do":"jam","duration":1}]})";
  ASSERT_EQ(load(scratch, good), "");
  for (size_t i = 0; i < good.size(); i++) {
    EXPECT_NE(load(scratch, good.substr(0, i)), "") << i;
    std::string changed = good;
    for (char c : {'[', '{', '0', '"', 'n'}) {
      changed[i] = c;
      load(scratch, changed);  // may be good still; must not crash
    }
  }
}
