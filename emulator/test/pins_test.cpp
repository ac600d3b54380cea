// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <set>

extern "C" {
#include "pins.h"
}

static void expect_pin(int pin, char port, int bit)
{
    EXPECT_EQ(pin_locate(pin).port, port) << pin;
    EXPECT_EQ(pin_locate(pin).bit, bit) << pin;
}

TEST(Pins, are_where_the_mega_has_them)
{
    expect_pin(0, 'E', 0);
    expect_pin(2, 'E', 4);
    expect_pin(4, 'G', 5);
    expect_pin(11, 'B', 5);
    expect_pin(12, 'B', 6);
    expect_pin(13, 'B', 7);
    expect_pin(22, 'A', 0);
    expect_pin(37, 'C', 0);
    expect_pin(49, 'L', 0);
    expect_pin(53, 'B', 0);
    expect_pin(54, 'F', 0);
    expect_pin(69, 'K', 7);
}

TEST(Pins, have_each_a_place_of_their_own_and_are_found_by_it)
{
    std::set<int> places;
    for (int pin = 0; pin < PIN_COUNT; pin++) {
        pin_location location = pin_locate(pin);
        EXPECT_EQ(pin_at(location.port, location.bit), pin);
        EXPECT_TRUE(places.insert(location.port * 8 + location.bit).second) << pin;
    }
    EXPECT_EQ(pin_at('D', 4), -1);
    EXPECT_EQ(pin_at('I', 0), -1);
}

TEST(Pins, are_read_from_text)
{
    EXPECT_EQ(pin_parse("0"), 0);
    EXPECT_EQ(pin_parse("69"), 69);
    EXPECT_EQ(pin_parse("A0"), 54);
    EXPECT_EQ(pin_parse("A15"), 69);
    for (const char *bad : {"", "A", "70", "A16", "-1", "1.5", "a0", "B3", "100", "12 ", "A+1"})
        EXPECT_EQ(pin_parse(bad), -1) << bad;
}
