#include <Arduino.h>
#include <board/Percepts.h>
#include <gtest/gtest.h>

#include <cstdio>

using javinolib::Percepts;

namespace {

// The literal of one percept, of a record without its type and length (SPEC 4.3).
template <typename Number>
std::string literalOf(Number number) {
  uint8_t bytes[64];
  javinolib::Reply reply(bytes, sizeof bytes);
  reply.begin();
  const javinolib::Length begin = reply.mark();
  javinolib::SerialCounters counters;
  javinolib::DeadBands deadBands(counters);
  Percepts(reply, deadBands).add(F("n"), number);
  return std::string(bytes + begin + 3, bytes + reply.mark());
}

std::string told(const char *format, unsigned whole, unsigned rest = 0) {
  char text[32];
  snprintf(text, sizeof text, format, whole, rest);
  return text;
}

}  // namespace

TEST(Numbers, all_of_16_bits_are_told_exactly) {
  for (unsigned number = 0; number <= UINT16_MAX; number++) {
    ASSERT_EQ(told("n(%u)", number), literalOf(number));
    ASSERT_EQ(told("n(%u.%02u)", number / 100, number % 100), literalOf(number / 100.0));
  }
}

TEST(Numbers, those_of_more_bits_are_told_exactly_down_to_16) {
  for (unsigned high = 1; high <= UINT16_MAX; high++) {
    const unsigned number = high << 16 | (high * 40503u & UINT16_MAX);
    ASSERT_EQ(told("n(%u)", number), literalOf(number));
  }
  for (unsigned near = UINT16_MAX - 9; near <= UINT16_MAX + 10u; near++) {
    ASSERT_EQ(told("n(%u)", 10 * near), literalOf(10 * near));
    ASSERT_EQ(told("n(%u)", near), literalOf(near));
  }
}
