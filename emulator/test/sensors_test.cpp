// SPDX-License-Identifier: GPL-3.0-or-later
#include "support.h"

#include <cmath>
#include <sstream>

// The readings that the program printed: centimetres, light, button.
static std::vector<std::vector<int>> readings(Emulation &run) {
  std::vector<std::vector<int>> all;
  for (const Event &line : run.events("car", "uart")) {
    std::istringstream text(line.text("line"));
    std::vector<int> numbers(3);
    text >> numbers[0] >> numbers[1] >> numbers[2];
    all.push_back(numbers);
  }
  return all;
}

static std::string car(const std::string &distance, const std::string &light, const std::string &button) {
  return R"({"boards":[{"name":"car","firmware":"@sensors","watch":[{"pin":5,"name":"go"}],"sensors":[
        {"type":"hc-sr04","trigger":22,"echo":2,)" +
         distance + R"(},
        {"type":"ldr","pin":"A0",)" +
         light + R"(},
        {"type":"digital","pin":40,)" +
         button + "}]}]}";
}

TEST(Sensors, are_read_as_the_scenario_says) {
  Scratch scratch;
  Emulation run(scratch, car(R"("distance":[[0,100]])", R"("light":[[0,800]])", R"("level":[[0,1],[0.35,0],[0.6,1]])"));
  run.run_until(1);
  auto all = readings(run);
  ASSERT_GE(all.size(), 8u);
  for (const auto &numbers : all) {
    EXPECT_NEAR(numbers[0], 100, 1);
    EXPECT_EQ(numbers[1], 800);
  }
  EXPECT_EQ(all[0][2], 1);
  EXPECT_EQ(all[3][2], 0);  // pulled down against the pull-up
  EXPECT_EQ(all[7][2], 1);
}

TEST(Sensors, change_over_time) {
  Scratch scratch;
  Emulation run(scratch, car(R"("distance":[[0,200],[1,100]])", R"("light":[[0,0],[1,1000]])", R"("level":[[0,1]])"));
  run.run_until(0.95);
  auto all = readings(run);
  for (size_t i = 1; i < all.size(); i++) {
    EXPECT_LT(all[i][0], all[i - 1][0]);
    EXPECT_GT(all[i][1], all[i - 1][1]);
  }
  EXPECT_NEAR(all[0][0], 190, 2);
  EXPECT_NEAR(all[0][1], 115, 20);
}

TEST(Sensors, wait_for_the_pin_that_starts_their_clock) {
  Scratch scratch;
  Emulation run(scratch, car(R"("distance":[[0,50],[0.01,20]],"after":{"pin":5,"level":1})",
                             R"("light":[[0,10],[0.01,900]],"after":{"pin":5,"level":1})",
                             R"("level":[[0,1],[0.05,0]],"after":{"pin":5})"));
  run.run_until(1);
  auto go = run.events("car", "pin");
  ASSERT_EQ(go.size(), 1u);
  auto lines = run.events("car", "uart");
  auto all = readings(run);
  for (size_t i = 0; i < all.size(); i++) {
    bool started = lines[i].t > go[0].t + 0.09;
    EXPECT_NEAR(all[i][0], started ? 20 : 50, 1) << i;
    if (lines[i].t < go[0].t || started) {
      EXPECT_EQ(all[i][1], started ? 900 : 10) << i;
      EXPECT_EQ(all[i][2], !started) << i;
    }
  }
}

TEST(Sensors, tremble_by_their_noise_and_the_seed) {
  std::vector<std::vector<int>> first;
  for (uint64_t seed : {1, 1, 2}) {
    Scratch scratch;
    Emulation run(scratch,
                  car(R"("distance":[[0,100]],"noise":5)", R"("light":[[0,1023]],"noise":20)", R"("level":[[0,1]])"),
                  seed);
    run.run_until(2);
    auto all = readings(run);
    ASSERT_GE(all.size(), 15u);
    double distances = 0, light = 0;
    for (const auto &numbers : all) {
      distances += std::pow(numbers[0] - 100, 2) / (double)all.size();
      light += numbers[1] / (double)all.size();
      EXPECT_LE(numbers[1], 1023);
    }
    EXPECT_GT(distances, 25 / 4.0);
    EXPECT_LT(distances, 25 * 4.0);
    EXPECT_NEAR(light, 1023 - 8, 8);  // half of them are cut off
    if (first.empty()) first = all;
    EXPECT_EQ(all == first, seed == 1);
  }
}

TEST(Sensors, out_of_reach_gives_the_long_pulse) {
  Scratch scratch;
  Emulation run(scratch, car(R"("distance":[[0,1000]])", R"("light":[[0,0]])", R"("level":[[0,0]])"));
  run.run_until(0.5);
  // 38 ms count over timer 1's 16 bits at 2 MHz: (76000 - 65536) / 2 / 58 = 90.
  EXPECT_NEAR(readings(run).at(0)[0], 90, 1);
}
