#include <board/Arguments.h>
#include <gtest/gtest.h>

#include <climits>

#include "support/Bytes.h"

using javinolib::Arguments;

namespace {

bool parse(Arguments &arguments, const Bytes &action) {
  return arguments.parse(action.data(), static_cast<uint16_t>(action.size()));
}

std::string name(const Arguments &arguments) { return std::string(arguments.name(), arguments.nameLength()); }

}  // namespace

TEST(Arguments, reads_name_and_arguments) {
  const struct {
    const char *action;
    const char *name;
    std::vector<std::string> texts;
  } cases[] = {
      {"stop", "stop", {}},
      {"speed(10,\"x\")", "speed", {"10", "x"}},
      {"speed( 10 , \"x\" )", "speed", {"10", "x"}},
      {"say(\"a,b(c\")", "say", {"a,b(c"}},
      {"say(\"a \\\"quote\\\" \\\\ and\\nmore\")", "say", {"a \"quote\" \\ and\nmore"}},
      {"go(to(1,2),[a,b],c)", "go", {"to(1,2)", "[a,b]", "c"}},
      {"say(\"\")", "say", {""}},
      {"act_2(é)", "act_2", {"é"}},
      {"jason.act(x)", "jason.act", {"x"}},
  };
  for (const auto &entry : cases) {
    SCOPED_TRACE(entry.action);
    const Bytes action = bytesOf(entry.action);
    Arguments arguments;
    ASSERT_TRUE(parse(arguments, action));
    EXPECT_EQ(entry.name, name(arguments));
    ASSERT_EQ(entry.texts.size(), arguments.count());
    for (uint8_t i = 0; i < arguments.count(); i++) {
      char text[32];
      EXPECT_TRUE(arguments.text(i, text, sizeof text));
      EXPECT_EQ(entry.texts[i], text);
    }
  }
}

TEST(Arguments, refuses_what_is_no_action) {
  for (const char *action :
       {"",       "(",      "()",         "(1)",    "f(",
        "f)",     "f()",    "f( )",       "f(,)",   "f(1,)",
        "f(,1)",  "f(1",    "f(1))",      "f((1)",  "f([1)",
        "f([1)]", "f(\"x)", "f(\"x\\\")", "f(1)x",  "f x",
        "f(1) ",  " f",     "é",          "f\"x\"", "f((((((((((((((((((((1))))))))))))))))))))"}) {
    const Bytes bytes = bytesOf(action);
    Arguments arguments;
    EXPECT_FALSE(parse(arguments, bytes)) << action;
  }
}

TEST(Arguments, reads_whole_numbers_that_a_long_holds) {
  const struct {
    std::string text;
    bool isInteger;
    long value;
  } cases[] = {{"0", true, 0},
               {"-0", true, 0},
               {"42", true, 42},
               {"-42", true, -42},
               {std::to_string(LONG_MAX), true, LONG_MAX},
               {std::to_string(LONG_MIN), true, LONG_MIN},
               {"9223372036854775808", false, 0},
               {"-9223372036854775809", false, 0},
               {"99999999999999999999999999", false, 0},
               {"1.5", false, 0},
               {"-", false, 0},
               {"--1", false, 0},
               {"+1", false, 0},
               {"1 2", false, 0},
               {"x", false, 0},
               {"\"1\"", false, 0}};
  for (const auto &entry : cases) {
    SCOPED_TRACE(entry.text);
    const Bytes action = bytesOf("f(" + entry.text + ")");
    Arguments arguments;
    ASSERT_TRUE(parse(arguments, action));
    long value = 4711;
    EXPECT_EQ(entry.isInteger, arguments.integer(0, value));
    EXPECT_EQ(entry.isInteger ? entry.value : 4711, value);
  }
}

TEST(Arguments, an_argument_that_is_not_there_is_told) {
  const Bytes action = bytesOf("f(1)");
  Arguments arguments;
  ASSERT_TRUE(parse(arguments, action));
  long value;
  char text[8];
  EXPECT_FALSE(arguments.integer(1, value));
  EXPECT_FALSE(arguments.text(1, text, sizeof text));
  EXPECT_FALSE(arguments.text(255, text, sizeof text));
}

TEST(Arguments, a_text_that_is_too_long_is_told) {
  const Bytes action = bytesOf("f(\"abc\")");
  Arguments arguments;
  ASSERT_TRUE(parse(arguments, action));
  for (size_t size = 0; size <= 3; size++) {
    Bytes text(size);  // the sanitizer watches its end
    EXPECT_FALSE(arguments.text(0, reinterpret_cast<char *>(text.data()), size)) << size;
  }
  char text[4];
  EXPECT_TRUE(arguments.text(0, text, sizeof text));
  EXPECT_STREQ("abc", text);
}

TEST(Arguments, hostile_text_never_breaks_it) {
  RandomBytes random(11);
  const std::string alphabet = "ab1-(),[]\"\\ \n\x80";
  for (int i = 0; i < 50000; i++) {
    Bytes action = bytesOf("f(");
    for (uint32_t length = random.number(30); length > 0; length--) {
      action.push_back(static_cast<uint8_t>(alphabet[random.number(static_cast<uint32_t>(alphabet.size()))]));
    }
    if (random.number(4) != 0) action.push_back(')');
    Arguments arguments;
    if (!parse(arguments, action)) continue;
    for (uint8_t index = 0; index <= arguments.count(); index++) {
      long value;
      char text[6];
      arguments.integer(index, value);
      arguments.text(index, text, sizeof text);
    }
  }
}
