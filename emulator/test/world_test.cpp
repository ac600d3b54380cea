// SPDX-License-Identifier: GPL-3.0-or-later
// Vehicles, obstacles, and what sensors measure of them.
#include "support.h"

#include <cmath>

extern "C" {
#include "world.h"
}

namespace {

// Vehicles of 1 m radius, at 4 m/s, whose motors the test turns.
struct Place {
  explicit Place(std::vector<std::pair<double, double>> positions)
      : boards(positions.size()), motors(2 * boards.size()) {
    for (size_t i = 0; i < boards.size(); i++) {
      boards[i].x_m = positions[i].first;
      boards[i].y_m = positions[i].second;
      boards[i].vehicle.speed_m_s = 4;
      boards[i].vehicle.radius_m = 1;
    }
    config.boards = boards.data();
    config.board_count = boards.size();
    config.world.light = 500;
    EXPECT_EQ(world_init(&w, &config, {this, motor, placed}), 0);
  }
  ~Place() { world_release(&w); }

  static int motor(void *context, size_t board, world_motor side) {
    return static_cast<Place *>(context)->motors[2 * board + side];
  }
  static void placed(void *context, size_t board, bool told, cycles_t at) {
    Place *place = static_cast<Place *>(context);
    place->moves++;
    if (told) place->told.emplace_back(board, at);
  }

  void put(const char *name, double x, double y, double radius) {
    obstacle_config obstacle = {const_cast<char *>(name), x, y, radius};
    EXPECT_EQ(world_put_obstacle(&w, &obstacle), 0);
  }
  void drive(int left, int right, double seconds) {
    motors[0] = left;
    motors[1] = right;
    world_wake(&w, now);
    for (cycles_t end = now + seconds_to_cycles(seconds); now < end; now += CYCLES_PER_MS) world_advance(&w, now);
  }

  std::vector<board_config> boards;
  std::vector<int> motors;
  scenario config = {};
  world w;
  cycles_t now = 0;
  int moves = 0;
  std::vector<std::pair<size_t, cycles_t>> told;
};

}  // namespace

TEST(World, both_motors_drive_straight_ahead_and_back) {
  Place place({{1, 2}});
  place.drive(1, 1, 1);
  EXPECT_NEAR(place.w.bodies[0].x_m, 5, 0.05);
  EXPECT_EQ(place.w.bodies[0].y_m, 2);
  place.drive(-1, -1, 0.5);
  EXPECT_NEAR(place.w.bodies[0].x_m, 3, 0.05);
  place.drive(0, 0, 1);
  EXPECT_NEAR(place.w.bodies[0].x_m, 3, 0.05);
  EXPECT_EQ(place.w.next_step, NEVER);
}

TEST(World, a_vehicle_inside_of_an_obstacle_measures_nothing_free) {
  Place place({{0, 0}});
  place.put("rock", -1, 0, 5);
  EXPECT_EQ(world_distance_m(&place.w, 0), 0);
  place.put("rock", -3, 0, 3.5);
  EXPECT_EQ(world_distance_m(&place.w, 0), INFINITY);
}

TEST(World, one_motor_turns) {
  Place place({{0, 0}});
  place.drive(0, 1, M_PI / 4 + 0.005);  // 4 m/s on a circle of 2 m: a quarter
  EXPECT_NEAR(place.w.bodies[0].heading_deg, 90, 2);
  EXPECT_GT(place.w.bodies[0].y_m, 0.8);
  place.drive(1, 0, M_PI / 2);
  EXPECT_NEAR(place.w.bodies[0].heading_deg, 270, 4);
  double x = place.w.bodies[0].x_m;
  place.drive(1, -1, 0.5);
  EXPECT_EQ(place.w.bodies[0].x_m, x);
}

TEST(World, a_vehicle_tells_where_it_is_every_50_ms_and_where_it_stops) {
  Place place({{0, 0}});
  place.drive(1, 1, 0.5);
  EXPECT_GE(place.told.size(), 9u);
  EXPECT_LE(place.told.size(), 11u);
  for (size_t i = 1; i < place.told.size(); i++)
    EXPECT_EQ(place.told[i].second - place.told[i - 1].second, WORLD_PLACE_INTERVAL);
  size_t before = place.told.size();
  place.drive(0, 0, 0.5);
  EXPECT_EQ(place.told.size(), before + 1);
}

TEST(World, a_vehicle_stops_at_contact_and_may_drive_back) {
  Place place({{0, 0}, {0, 50}});
  place.put("rock", 5, 0, 0.5);
  EXPECT_NEAR(world_distance_m(&place.w, 0), 3.5, 1e-9);
  place.drive(1, 1, 2);
  EXPECT_NEAR(place.w.bodies[0].x_m, 3.5, 1e-9);
  EXPECT_NEAR(world_distance_m(&place.w, 0), 0, 1e-9);
  place.drive(-1, -1, 0.5);
  EXPECT_NEAR(place.w.bodies[0].x_m, 1.5, 0.05);
  EXPECT_EQ(world_remove_obstacle(&place.w, "rock"), 0);
  EXPECT_EQ(world_remove_obstacle(&place.w, "rock"), -1);
  EXPECT_TRUE(std::isinf(world_distance_m(&place.w, 0)));
}

TEST(World, the_nearest_thing_straight_ahead_is_what_counts) {
  Place place({{0, 0}, {20, 0.5}, {-5, 0}});
  EXPECT_NEAR(world_distance_m(&place.w, 0), 20 - std::sqrt(0.75) - 1, 1e-9);  // another vehicle
  place.put("beside", 5, 1.5, 1);
  EXPECT_GT(world_distance_m(&place.w, 0), 10);
  place.put("beside", 5, 0, 1);  // moved into the way
  EXPECT_NEAR(world_distance_m(&place.w, 0), 3, 1e-9);
  world_move(&place.w, 0, 0, 0, -180, 0);
  EXPECT_NEAR(world_distance_m(&place.w, 0), 3, 1e-9);  // the one behind
  EXPECT_EQ(place.w.bodies[0].heading_deg, 180);
}

TEST(World, has_room_for_so_many_obstacles) {
  Place place({{0, 0}});
  for (int i = 0; i < MAX_OBSTACLES; i++) place.put(std::to_string(i).c_str(), 0, i, 1);
  obstacle_config more = {const_cast<char *>("more"), 0, 0, 1};
  EXPECT_EQ(world_put_obstacle(&place.w, &more), -1);
}

// The program's pin 5 goes high after 500 ms: the only motor that it turns.
static const char SENSING_CAR[] = R"({"boards":[{"name":"car","firmware":"@sensors","position":[1,1],
    "vehicle":{"heading":0,"speed":2,"radius":0.5,"forward":[5,5],"backward":[6,6]},"sensors":[
      {"type":"hc-sr04","trigger":22,"echo":2,"distance":"world"},{"type":"ldr","pin":"A0","light":"world"}]}],
    "world":{"light":321,"obstacles":[{"name":"rock","position":[4,1],"radius":0.5}]}})";

TEST(World, a_board_drives_and_measures_what_is_ahead) {
  Scratch scratch;
  Emulation run(scratch, SENSING_CAR);
  run.run_until(2.5);
  auto lines = run.events("car", "uart");
  int cm = 0, light = 0;
  ASSERT_EQ(sscanf(lines.at(0).text("line").c_str(), "%d %d", &cm, &light), 2);
  EXPECT_NEAR(cm, 200, 1);
  EXPECT_EQ(light, 321);
  ASSERT_EQ(sscanf(lines.back().text("line").c_str(), "%d", &cm), 1);
  EXPECT_EQ(cm, 2);
  auto places = run.events("car", "place");
  ASSERT_GT(places.size(), 15u);
  EXPECT_NEAR(places[0].t, 0.58, 0.04);
  EXPECT_NEAR(json_number_value(json_array_get(json_object_get(places.back().fields, "position"), 0)), 3, 0.001);
  EXPECT_NEAR(places.back().t - places[0].t, 1, 0.03);
}

TEST(World, a_board_on_a_path_is_where_it_says_and_heard_from_there) {
  Scratch scratch;
  Emulation run(scratch, R"({"radio":{"range":50},"boards":[{"name":"sender","firmware":"@rf_send"},
      {"name":"mirror","firmware":"@rf_mirror","path":[[0.5,[10,0]],[1.5,[110,0]],[2.5,[110,0]],[3.5,[10,0]]]}]})");
  const world_body *mirror = &run.e.surroundings.bodies[1];
  run.run_until(0.4);
  EXPECT_EQ(mirror->x_m, 10);
  EXPECT_TRUE(run.events("place").empty());
  run.run_until(0.755);
  EXPECT_NEAR(mirror->x_m, 35, 0.001);  // to 10 ms, as vehicles
  EXPECT_NEAR(run.events("mirror", "place").back().t, 0.75, 0.05);
  run.run_until(2);
  EXPECT_EQ(mirror->x_m, 110);
  size_t places = run.events("place").size();
  run.run_until(2.4);
  EXPECT_EQ(run.events("place").size(), places) << "it stands still";
  run.run_until(4.4);
  EXPECT_EQ(mirror->x_m, 10);
  EXPECT_EQ(run.e.surroundings.next_step, NEVER);
  // A packet each 0.39 s: those of the middle are out of range.
  for (const Event &heard : run.events("mirror", "rf-rx")) EXPECT_TRUE(heard.t < 0.9 || heard.t > 3.1) << heard.t;
  EXPECT_GE(run.events("mirror", "rf-rx").size(), 4u);
}

TEST(World, a_move_ends_a_path) {
  Scratch scratch;
  Emulation run(scratch, R"({"boards":[{"name":"a","firmware":"@halt","path":[[0,[0,0]],[10,[100,0]]]}]})");
  run.run_until(1);
  EXPECT_NEAR(run.e.surroundings.bodies[0].x_m, 10, 0.2);
  EXPECT_EQ(run.command(R"({"do":"move","board":"a","position":[5,5]})"), "");
  run.run_until(2);
  EXPECT_EQ(run.e.surroundings.bodies[0].x_m, 5);
  EXPECT_EQ(run.e.surroundings.next_step, NEVER);
}

TEST(World, a_reset_board_stands_still) {
  Scratch scratch;
  Emulation run(scratch, SENSING_CAR);
  run.run_until(0.7);
  EXPECT_EQ(run.command(R"({"do":"power-cut","board":"car","duration":5})"), "");
  run.run_until(0.8);
  size_t places = run.events("car", "place").size();
  run.run_until(2);
  EXPECT_EQ(run.events("car", "place").size(), places);
}

TEST(World, the_trace_begins_with_the_scenario) {
  Scratch scratch;
  std::string car = SENSING_CAR;
  Emulation run(scratch, car.insert(car.find(R"("position")"), R"("port":"tty",)"), 7);
  std::string trace = run.trace_text();
  EXPECT_EQ(
      trace.substr(0, trace.find('\n')),
      R"({"t":0.000000,"event":"scenario","version":3,"seed":7,"radio":{"bitRate":2000.0,"range":100.0,"bitErrorRate":0.0},)"
      R"("boards":[{"name":"car","model":"mega","position":[1.0,1.0],)"
      R"("sensors":[{"type":"hc-sr04","pin":2},{"type":"ldr","pin":"A0"}],"watch":[],"port":"tty","heading":0.0,"radius":0.5}],)"
      R"("world":{"light":321.0,"obstacles":[{"name":"rock","position":[4.0,1.0],"radius":0.5}]}})");
}
