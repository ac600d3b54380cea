// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cstring>
#include <set>

extern "C" {
#include "model.h"
}

static void expect_pin(const model &m, int pin, char port, int bit) {
  EXPECT_EQ(pin_locate(&m, pin).port, port) << pin;
  EXPECT_EQ(pin_locate(&m, pin).bit, bit) << pin;
}

TEST(Pins, are_where_the_mega_has_them) {
  expect_pin(MEGA, 0, 'E', 0);
  expect_pin(MEGA, 2, 'E', 4);
  expect_pin(MEGA, 4, 'G', 5);
  expect_pin(MEGA, 11, 'B', 5);
  expect_pin(MEGA, 12, 'B', 6);
  expect_pin(MEGA, 13, 'B', 7);
  expect_pin(MEGA, 22, 'A', 0);
  expect_pin(MEGA, 37, 'C', 0);
  expect_pin(MEGA, 49, 'L', 0);
  expect_pin(MEGA, 53, 'B', 0);
  expect_pin(MEGA, 54, 'F', 0);
  expect_pin(MEGA, 69, 'K', 7);
}

TEST(Pins, are_where_the_uno_has_them) {
  expect_pin(UNO, 0, 'D', 0);
  expect_pin(UNO, 7, 'D', 7);
  expect_pin(UNO, 8, 'B', 0);
  expect_pin(UNO, 11, 'B', 3);
  expect_pin(UNO, 12, 'B', 4);
  expect_pin(UNO, 13, 'B', 5);
  expect_pin(UNO, 14, 'C', 0);
  expect_pin(UNO, 19, 'C', 5);
}

TEST(Pins, have_each_a_place_of_their_own_and_are_found_by_it) {
  for (const model *m : {&MEGA, &UNO, &PRO_MINI}) {
    std::set<int> places;
    ASSERT_EQ(std::strlen(m->locations), 2u * static_cast<unsigned>(m->pin_count));
    for (int pin = 0; pin < m->pin_count; pin++) {
      pin_location location = pin_locate(m, pin);
      EXPECT_EQ(pin_at(m, location.port, location.bit), pin);
      EXPECT_TRUE(places.insert(location.port * 8 + location.bit).second) << pin;
    }
    EXPECT_EQ(pin_at(m, 'I', 0), -1);
  }
  EXPECT_EQ(pin_at(&MEGA, 'D', 4), -1);
  EXPECT_EQ(pin_at(&UNO, 'C', 6), -1);
}

TEST(Pins, are_read_from_text) {
  EXPECT_EQ(pin_parse(&MEGA, "0"), 0);
  EXPECT_EQ(pin_parse(&MEGA, "69"), 69);
  EXPECT_EQ(pin_parse(&MEGA, "A0"), 54);
  EXPECT_EQ(pin_parse(&MEGA, "A15"), 69);
  EXPECT_EQ(pin_parse(&UNO, "19"), 19);
  EXPECT_EQ(pin_parse(&UNO, "A5"), 19);
  for (const char *bad : {"", "A", "70", "A16", "-1", "1.5", "a0", "B3", "100", "12 ", "A+1"})
    EXPECT_EQ(pin_parse(&MEGA, bad), -1) << bad;
  for (const char *bad : {"20", "A6"}) EXPECT_EQ(pin_parse(&UNO, bad), -1) << bad;
}

TEST(Pins, that_are_analog_are_the_converters_first_eight) {
  EXPECT_FALSE(pin_is_analog(&MEGA, 53));
  EXPECT_TRUE(pin_is_analog(&MEGA, 61));
  EXPECT_FALSE(pin_is_analog(&MEGA, 62));
  EXPECT_FALSE(pin_is_analog(&UNO, 13));
  EXPECT_TRUE(pin_is_analog(&UNO, 19));
}
