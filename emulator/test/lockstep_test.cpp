// SPDX-License-Identifier: GPL-3.0-or-later
// Lock-step: lines in, answers out, and the same run however it is cut into commands.
#include "support.h"

#include <algorithm>

extern "C" {
#include "control.h"
#include "lockstep.h"
}

namespace {

const char ECHOING[] = R"({"boards":[{"name":"a","firmware":"@uart_echo","port":"a"}]})";

constexpr cycles_t LATER = 10 * CYCLES_PER_SECOND;

// An emulation in lock-step, and what was answered.
struct Locked {
  explicit Locked(const std::string &json, uint64_t seed = 1) : run(scratch, json, seed, true) {
    answers = open_memstream(&text, &size);
    lockstep_init(&l, &run.e, end, {this, perform, pass}, answers);
  }
  ~Locked() {
    fclose(answers);
    free(text);
  }

  static int perform(void *context, const char *line, size_t length, char *error, size_t size) {
    std::string wrong = static_cast<Locked *>(context)->run.command(std::string(line, length));
    snprintf(error, size, "%s", wrong.c_str());
    return wrong.empty() ? 0 : -1;
  }
  static bool pass(void *context) {
    Locked *locked = static_cast<Locked *>(context);
    locked->passes++;
    return !locked->broken_off;
  }

  lockstep_state take(const std::string &bytes) { return lockstep_take(&l, bytes.data(), bytes.size()); }

  // Gives lines; returns what is answered, without the last line's end.
  std::string say(const std::string &lines) {
    size_t before = size;
    EXPECT_EQ(take(lines + "\n"), LOCKSTEP_ON) << l.error;
    EXPECT_EQ(text[size - 1], '\n');
    return std::string(text + before, size - before - 1);
  }
  // Runs until there is news or that cycle; returns the cycle, and the news in `news`.
  cycles_t run_to(cycles_t until, std::string *news) {
    std::string answer = say("run " + std::to_string(until));
    *news = answer.substr(std::min(answer.find(' '), answer.size()));
    return std::stoull(answer);
  }

  const pty &port(size_t board = 0) { return run.e.nodes[board].port; }

  Scratch scratch;
  Emulation run;
  cycles_t end = NEVER;
  lockstep l;
  FILE *answers;
  char *text = nullptr;
  size_t size = 0;
  int passes = 0;
  bool broken_off = false;
};

struct Action {
  cycles_t at;
  std::string line;
};

// Does all actions, with runs of at most so many cycles. Returns the news, each with its cycle, and then the trace.
std::string story(const std::string &json, const std::vector<Action> &actions, cycles_t longest, uint64_t seed = 1) {
  Locked locked(json, seed);
  std::string told, news;
  cycles_t now = 0;
  for (const Action &action : actions) {
    while (now < action.at) {
      now = locked.run_to(std::min(action.at, now + longest), &news);
      if (!news.empty()) told += std::to_string(now) + news + "\n";
    }
    if (!action.line.empty()) told += locked.say(action.line) + "\n";
  }
  locked.run.close();
  return told + locked.run.trace_text();
}

void expect_the_same_in_all_slices(const std::string &json, const std::vector<Action> &actions, uint64_t seed = 1) {
  const std::string whole = story(json, actions, LATER, seed);
  EXPECT_EQ(story(json, actions, LATER, seed), whole);
  for (cycles_t longest : {1u, 1600u, 2001u, 7777u, 16000u, 123456u})
    EXPECT_EQ(story(json, actions, longest, seed), whole);
}

std::string refusal(const std::string &lines) {
  Locked locked(R"({"boards":[{"name":"a","firmware":"@uart_echo","port":"a"},{"name":"b","firmware":"@blink"}]})");
  EXPECT_EQ(locked.take("open 0\n" + lines + "\n"), LOCKSTEP_REFUSED) << lines;
  return locked.l.error;
}

}  // namespace

TEST(Lockstep, time_goes_on_only_as_it_is_told) {
  Locked locked(ECHOING);
  EXPECT_EQ(locked.say("run 0"), "0");
  EXPECT_EQ(locked.say("run 1"), "1600");  // a turn is not cut
  EXPECT_EQ(locked.say("run 1600"), "1600");
  EXPECT_EQ(locked.say("run 1601"), "3200");
  EXPECT_EQ(locked.say("run 0"), "3200");
  EXPECT_EQ(locked.say("run 16000000"), "16000000");
  EXPECT_EQ(locked.run.e.now, 16000000u);
}

TEST(Lockstep, ends_at_the_end_of_the_run) {
  Locked locked(ECHOING);
  locked.l.end = 5000;
  EXPECT_EQ(locked.take("run 4800\nrun 9223372036854775807\nrun 1\n"), LOCKSTEP_ENDED);
  EXPECT_EQ(std::string(locked.text), "4800\n5000\n");
}

TEST(Lockstep, what_is_due_beside_the_run_is_done_each_millisecond_and_may_break_it_off) {
  Locked locked(R"({"boards":[{"name":"a","firmware":"@rf_send"}]})");  // it never sleeps
  locked.say("run 160000");
  EXPECT_EQ(locked.passes, 10);
  locked.broken_off = true;
  EXPECT_EQ(locked.take("run 320000\n"), LOCKSTEP_ENDED);
  EXPECT_LT(locked.run.e.now, 320000u);
}

TEST(Lockstep, opening_resets_the_board) {
  Locked locked(ECHOING);
  EXPECT_EQ(locked.say("run 16000\nopen 0\nclose 0\nopen 0"), "16000\nok\nok\nok");
  auto resets = locked.run.events("a", "reset");
  ASSERT_EQ(resets.size(), 3u);
  EXPECT_EQ(resets[1].text("why"), "port opened");
  EXPECT_EQ(resets[1].real("t"), 0.001);
  EXPECT_EQ(locked.run.events("a", "port").size(), 3u);
}

TEST(Lockstep, bytes_are_handed_over_with_a_zero_among_them) {
  Locked locked(ECHOING);
  EXPECT_EQ(locked.say("open 0\nrun 160000\nwrite 0 010200"), "ok\n160000\n3");
  std::string news;
  cycles_t now = locked.run_to(LATER, &news);
  EXPECT_EQ(news, " 0 010200");
  EXPECT_GE(now, locked.port().put_at);
  EXPECT_LT(now, locked.port().put_at + RF_STEP);
}

TEST(Lockstep, bytes_are_handed_over_when_none_follows_for_a_millisecond) {
  Locked locked(ECHOING);
  EXPECT_EQ(locked.say("open 0\nrun 160000\nwrite 0 0102fF"), "ok\n160000\n3");
  std::string news;
  cycles_t now = locked.run_to(LATER, &news);
  EXPECT_EQ(news, " 0 0102ff");
  EXPECT_GE(now, locked.port().put_at + CYCLES_PER_MS);
  EXPECT_LT(now, locked.port().put_at + CYCLES_PER_MS + RF_STEP);
}

TEST(Lockstep, bytes_are_handed_over_while_all_boards_sleep) {
  Locked locked(R"({"boards":[{"name":"a","firmware":"@sleep_greets","port":"a"}]})");
  EXPECT_EQ(locked.say("open 0"), "ok");
  std::string news;
  cycles_t now = locked.run_to(LATER, &news);
  EXPECT_EQ(news, " 0 7a");
  EXPECT_GE(now, locked.port().put_at + CYCLES_PER_MS);
  EXPECT_LT(now, locked.port().put_at + CYCLES_PER_MS + RF_STEP);
}

TEST(Lockstep, bytes_for_a_board_that_sleeps_are_lost) {
  Locked locked(R"({"boards":[{"name":"a","firmware":"@sleep_deaf","port":"a"}]})");
  EXPECT_EQ(locked.say("open 0\nwrite 0 " + std::string(1000, '0') + "\nrun 160000"), "ok\n500\n160000");
  EXPECT_EQ(locked.port().in_end - locked.port().in_start, 0u);
}

TEST(Lockstep, bytes_are_handed_over_when_there_are_many) {
  Locked locked(ECHOING);
  const std::string HEX(600, '1');
  EXPECT_EQ(locked.say("open 0\nrun 160000\nwrite 0 " + HEX), "ok\n160000\n300");
  std::string news;
  cycles_t now = locked.run_to(LATER, &news);
  EXPECT_GE(news.size(), 3u + 2 * 256);
  EXPECT_LE(news.size(), 3u + 2 * 258);
  EXPECT_LT(now, locked.port().put_at + RF_STEP);
  std::string rest;
  locked.run_to(LATER, &rest);
  EXPECT_EQ(news.substr(3) + rest.substr(3), HEX);
}

TEST(Lockstep, bytes_are_handed_over_as_the_bridge_passes_them_on) {
  Locked locked(R"({"boards":[{"name":"a","firmware":"@uart_echo","port":"a","bridge":{"latency":16}}]})");
  EXPECT_EQ(locked.say("run 16000\nopen 0\nwrite 0 " + std::string(200, '0')), "16000\nok\n100");
  std::string news;
  cycles_t full = locked.run_to(LATER, &news);
  EXPECT_LT(full, locked.port().put_at + RF_STEP);
  EXPECT_EQ(news, " 0 " + std::string(124, '0'));
  cycles_t now = locked.run_to(LATER, &news);
  EXPECT_EQ(news, " 0 " + std::string(76, '0'));
  EXPECT_LE(now, full + 16 * CYCLES_PER_MS + RF_STEP);
  EXPECT_GT(now, full + 15 * CYCLES_PER_MS);
}

TEST(Lockstep, a_bridge_starts_its_timer_when_the_port_is_opened) {
  Locked locked(R"({"boards":[{"name":"a","firmware":"@uart_echo","port":"a","bridge":{"latency":16}}]})");
  EXPECT_EQ(locked.say("run 80000\nopen 0\nwrite 0 78"), "80000\nok\n1");
  EXPECT_EQ(locked.say("run 16000000"), std::to_string((5 + 16) * CYCLES_PER_MS) + " 0 78");
}

TEST(Lockstep, nothing_is_handed_over_without_a_host) {
  Locked locked(R"({"boards":[{"name":"a","firmware":"@blink","port":"a"}]})");
  EXPECT_EQ(locked.say("run 1600000"), "1600000");
  locked.run.close();
  EXPECT_EQ(locked.run.events("a", "counters").at(0).number("serialDropped"), 6);
}

TEST(Lockstep, a_port_takes_as_many_bytes_as_it_has_room_for) {
  Locked locked(ECHOING);
  EXPECT_EQ(locked.say("open 0\nwrite 0 " + std::string(8192, '7') + "\nwrite 0 7777"), "ok\n4096\n0");
  std::string news, all;
  while (locked.run_to(32000000, &news) < 32000000)
    for (size_t i = 3; i < news.size(); i++) all += news[i];
  EXPECT_EQ(all, std::string(8192, '7'));
  EXPECT_EQ(locked.say("write 0 77"), "1");
}

TEST(Lockstep, a_port_is_taken_away_and_given_back) {
  Locked locked(R"({"boards":[{"name":"x","firmware":"@blink"},{"name":"a","firmware":"@uart_echo","port":"a"}],
    "faults":[{"t":0.05,"board":"a","do":"unplug"},{"t":0.1,"board":"a","do":"plug"}]})");
  EXPECT_EQ(locked.say("open 1\nrun 16000000"), "ok\n801600 1 unplugged");
  EXPECT_EQ(locked.say("write 1 00\nopen 1\nclose 1"), "unplugged\nunplugged\nunplugged");
  EXPECT_EQ(locked.say("run 16000000"), "1601600 1 plugged");
  EXPECT_EQ(locked.say("open 1\nrun 1760000\nwrite 1 00"), "ok\n1760000\n1");
  std::string news;
  locked.run_to(16000000, &news);
  EXPECT_EQ(news, " 1 00");
  EXPECT_EQ(locked.say("run 16000000"), "16000000");
  auto ports = locked.run.events("a", "port");
  std::vector<std::string> states;
  for (const Event &event : ports) states.push_back(event.text("state"));
  EXPECT_EQ(states, (std::vector<std::string>{"open", "unplugged", "plugged", "open"}));
}

TEST(Lockstep, a_port_goes_with_the_power_and_its_bytes_are_counted) {
  Locked locked(R"({"boards":[{"name":"a","firmware":"@uart_echo","port":"a"}],
    "faults":[{"t":0.0109,"board":"a","do":"power-cut","duration":0.01}]})");
  EXPECT_EQ(locked.say("open 0\nrun 160000\nwrite 0 0102030405"), "ok\n160000\n5");
  EXPECT_EQ(locked.say("run 16000000\nrun 16000000"), "176000 0 unplugged\n336000 0 plugged");
  EXPECT_GT(locked.port().dropped, 0u);
}

TEST(Lockstep, a_host_that_lost_its_port_is_told_even_if_it_is_back) {
  Locked locked(ECHOING);
  EXPECT_EQ(locked.say(R"({"do":"unplug","board":"a"})"
                       "\n"
                       R"({"do":"plug","board":"a"})"
                       "\nrun 16000"),
            "{\"ok\":true}\n{\"ok\":true}\n16000");
  EXPECT_EQ(locked.say("open 0\nrun 160000"), "ok\n160000");
  EXPECT_EQ(locked.say(R"({"do":"unplug","board":"a"})"
                       "\nwrite 0 00\n"
                       R"({"do":"plug","board":"a"})"
                       "\nwrite 0 00\nopen 0\nclose 0\nrun 16000000\nopen 0\nrun 16000000"),
            "{\"ok\":true}\nunplugged\n{\"ok\":true}\nunplugged\nunplugged\nunplugged\n"
            "160000 0 unplugged 0 plugged\nok\n16000000");
}

TEST(Lockstep, commands_are_answered_as_by_the_control_socket_and_do_not_end_the_run) {
  Locked locked(ECHOING);
  EXPECT_EQ(locked.say("run 16000\n"
                       R"({"do":"reset","board":"a"})"
                       "\n"
                       R"({"do":"reset","board":"b"})"
                       "\n{\nrun 32000"),
            "16000\n{\"ok\":true}\n"
            R"({"error":"command: board: expected the name of one of the boards, found \"b\""})"
            "\n"
            R"({"error":"command: column 1: string or '}' expected near end of file"})"
            "\n32000");
  EXPECT_EQ(locked.run.events("a", "command").at(0).number("cycle"), 16000);
}

TEST(Lockstep, lines_may_come_in_any_pieces) {
  const std::string LINES =
      "open 0\nrun 160000\nwrite 0 414200\n{\"do\":\"jam\",\"duration\":0.1}\nrun 1600000\nclose 0\n";
  Locked whole(ECHOING);
  EXPECT_EQ(whole.take(LINES), LOCKSTEP_ON);
  for (size_t piece : {1, 2, 7}) {
    Locked locked(ECHOING);
    for (size_t i = 0; i < LINES.size(); i += piece) EXPECT_EQ(locked.take(LINES.substr(i, piece)), LOCKSTEP_ON);
    EXPECT_EQ(std::string(locked.text), whole.text);
    EXPECT_EQ(locked.run.trace_text(), whole.run.trace_text());
  }
}

TEST(Lockstep, each_mistake_gets_a_line_that_says_what_was_expected) {
  const std::string WHERE = "standard input, line 2: expected ", BOARD = "the number of a board with a port, from 0";
  const std::string CYCLE = "a cycle, 0 to 9223372036854775807", BYTES = "1 to 4096 bytes in hexadecimal digits";
  const std::string COMMAND = "run, open, close, write or {";
  const std::vector<std::vector<std::string>> CASES = {
      {"", COMMAND, ""},
      {" run 5", COMMAND, ""},
      {"jump 5", COMMAND, "jump"},
      {"RUN 5", COMMAND, "RUN"},
      {"[]", COMMAND, "[]"},
      {"run", CYCLE, ""},
      {"run ", CYCLE, ""},
      {"run -1", CYCLE, "-1"},
      {"run +1", CYCLE, "+1"},
      {"run 0x10", CYCLE, "0x10"},
      {"run 1 2", CYCLE, "1 2"},
      {"run  1", CYCLE, " 1"},
      {"run 1\r", CYCLE, "1?"},
      {"run 9223372036854775808", CYCLE, "9223372036854775808"},
      {"run 99999999999999999999999999", CYCLE, "99999999999999999999999999"},
      {"open", BOARD, ""},
      {"open a", BOARD, "a"},
      {"open 1", BOARD, "1"},
      {"open 2", BOARD, "2"},
      {"open 18446744073709551616", BOARD, "18446744073709551616"},
      {"open 0 0", "nothing behind the board", "0"},
      {"open 0", "a port that no host has open", "a"},
      {"close 0 x", "nothing behind the board", "x"},
      {"write 0", BYTES, ""},
      {"write 0 ", BYTES, ""},
      {"write 0 0", BYTES, "0"},
      {"write 0 0g", BYTES, "0g"},
      {"write 0 00 00", BYTES, "00 00"},
      {"write 0 " + std::string(8194, '0'), BYTES, std::string(60, '0')},
      {std::string("run 1\0 2", 8), "no byte 0x00", "run 1"},
      {"\x1b[2J\xff", COMMAND, "?[2J?"},
      {std::string(8208, 'x'), COMMAND, std::string(60, 'x')},
      {std::string(8209, 'x'), "at most 8208 bytes in a line", std::string(60, 'x')},
  };
  for (const auto &c : CASES) EXPECT_EQ(refusal(c[0]), WHERE + c[1] + ", found \"" + c[2] + "\"");
  EXPECT_EQ(refusal("close 0\nclose 0"), "standard input, line 3: expected a port that a host has open, found \"a\"");
  EXPECT_EQ(refusal("close 0\nwrite 0 00"),
            "standard input, line 3: expected a port that a host has open, found \"a\"");
}

TEST(Lockstep, random_lines_are_refused_or_performed) {
  static const std::string PARTS[] = {"run ", "open ", "close ", "write ",  "0", "1",    "9",
                                      "7f",   " ",     "{",      "\"do\":", "}", "\xff", std::string(1, '\0'),
                                      "\n",   "\n",    "\n"};
  prng random;
  prng_seed(&random, 1, 0);
  int refused = 0;
  for (int round = 0; round < 100; round++) {
    Locked locked(ECHOING);
    std::string lines;
    for (int part = 0; part < 50; part++) lines += PARTS[prng_next(&random) % std::size(PARTS)];
    lockstep_state state = locked.take(lines);
    EXPECT_TRUE(state == LOCKSTEP_ON || state == LOCKSTEP_REFUSED) << lines;
    EXPECT_EQ(state == LOCKSTEP_REFUSED, locked.l.error[0] != '\0');
    refused += state == LOCKSTEP_REFUSED;
  }
  EXPECT_GT(refused, 50);
}

TEST(Lockstep, a_line_without_its_end_is_not_performed) {
  Locked locked(ECHOING);
  EXPECT_EQ(locked.take("run 1600\nrun 160"), LOCKSTEP_ON);
  EXPECT_EQ(lockstep_finish(&locked.l), LOCKSTEP_REFUSED);
  EXPECT_STREQ(locked.l.error, "standard input, line 2: expected the end of the line, found \"run 160\"");
  EXPECT_EQ(locked.run.e.now, 1600u);
}

TEST(Lockstep, answers_that_cannot_be_written_end_the_run) {
  Locked locked(ECHOING);
  FILE *full = fopen("/dev/full", "w");
  locked.l.answers = full;
  EXPECT_EQ(locked.take("run 1600\n"), LOCKSTEP_FAILED);
  EXPECT_STREQ(locked.l.error, "the answers cannot be written any more");
  fclose(full);
}

TEST(Lockstep, a_program_that_crashes_ends_the_run) {
  Locked locked(R"({"boards":[{"name":"a","firmware":"@crash"}]})");
  EXPECT_EQ(locked.take("run 1600000000\n"), LOCKSTEP_FAILED);
  EXPECT_NE(std::string(locked.l.error).find("its program crashed"), std::string::npos) << locked.l.error;
}

TEST(LockstepSlices, of_boards_that_sleep_are_the_same_run) {
  expect_the_same_in_all_slices(
      R"({"boards":[
        {"name":"a","firmware":"@uart_echo","port":"a","clockError":7000},
        {"name":"b","firmware":"@blink","port":"b","bridge":{"latency":3},"watch":[{"pin":13,"name":"led"}]},
        {"name":"c","firmware":"@uno_sleep","model":"uno","port":"c","watch":[{"pin":13,"name":"awake"},{"pin":10,"name":"heard"}],
         "path":[[0,[0,0]],[0.3,[9,9]]]}],
        "faults":[{"t":0.0500011,"board":"a","do":"unplug"},{"t":0.0777777,"board":"a","do":"plug"},
          {"t":0.0112345,"board":"b","do":"power-cut","duration":0.0123456},{"t":0.21,"board":"c","do":"reset"}]})",
      {{1000, "open 0"},
       {1700, "open 1\nopen 2"},
       {200000, "write 0 01020304"},
       {300000, "write 0 0100020000"},
       {500001, "{\"do\":\"light\",\"value\":3}"},
       {700001, "write 0 " + std::string(1000, '3') + "\nwrite 2 414243"},
       {1500000, "open 0"},
       {1900000, "write 0 0101\nwrite 2 00"},
       {4000000, ""}});
}

TEST(LockstepSlices, of_boards_that_sleep_long_are_the_same_run) {
  expect_the_same_in_all_slices(
      R"({"boards":[
        {"name":"a","firmware":"@blink","port":"a","watch":[{"pin":13,"name":"led"}],"clockError":-9000},
        {"name":"b","firmware":"@sleep_greets","port":"b","bridge":{"latency":3}},
        {"name":"c","firmware":"@sleep_greets","port":"c"}],
        "faults":[{"t":0.0165432,"board":"a","do":"reset"},{"t":0.0312345,"board":"a","do":"unplug"},
          {"t":0.0456789,"board":"a","do":"plug"},{"t":0.0512345,"board":"b","do":"power-cut","duration":0.0123456},
          {"t":0.07,"board":"a","do":"reset"}]})",
      {{0, "open 0\nopen 1\nopen 2"}, {1000000, "open 0"}, {1050000, "open 1"}, {1600000, ""}});
}

TEST(LockstepSlices, of_boards_with_radio_are_the_same_run) {
  expect_the_same_in_all_slices(
      R"({"radio":{"bitErrorRate":0.001,"noise":{"edges":2000,"after":0.05}},"boards":[
        {"name":"a","firmware":"@rf_send","clockError":-3000},{"name":"b","firmware":"@rf_mirror","port":"b","position":[3,4]},
        {"name":"c","firmware":"@blink","port":"c"}],
        "faults":[{"t":0.123,"do":"jam","duration":0.05},{"t":0.2,"board":"a","do":"power-cut","duration":0.07}]})",
      {{5000, "open 1\nopen 2"},
       {900000, R"({"do":"send","position":[1,1],"payload":"2f2f2f"})"},
       {2000000, R"({"do":"move","board":"b","position":[500,0]})"},
       {5000000, ""}},
      3);
}

TEST(LockstepSlices, of_boards_with_serial_modules_are_the_same_run) {
  expect_the_same_in_all_slices(
      R"({"radio":{"module":"hc-12","loss":0.1},"boards":[
        {"name":"a","firmware":"@module_send_later"},{"name":"b","firmware":"@module_mirror","port":"b"},
        {"name":"c","firmware":"@module_send_much"}]})",
      {{5000, "open 1"}, {4000000, ""}});
}

TEST(LockstepSketch, of_the_library_answers_its_host) {
  const char BOARD[] = R"({"boards":[{"name":"lamp","firmware":")" LIBRARY_BLINK R"(","model":"uno","port":"lamp"}]})";
  const std::string HELLO_PACKET = "010f2b2b2b2b2b2b2b2b4151480172e700";  // vectors/packets.json
  Locked locked(BOARD);
  locked.say("open 0");
  std::string news, all;
  while (locked.run_to(8000000, &news) < 8000000) all += news;
  EXPECT_EQ(all, " 0 00 0 0100");  // it has started, and asks again (SPEC 4.1)
  EXPECT_EQ(locked.say("write 0 00" + HELLO_PACKET), std::to_string(HELLO_PACKET.size() / 2 + 1));
  std::vector<std::string> told;
  while (locked.run_to(16000000, &news) < 16000000) told.push_back(news);
  ASSERT_EQ(told.size(), 3u);
  EXPECT_EQ(told[0], " 0 00");  // the request is taken, and the reply begins (SPEC 4.2)
  EXPECT_EQ(told[1], " 0 00");
  EXPECT_EQ(told[2].substr(0, 7), " 0 010b");
  EXPECT_NE(told[2].find("626c696e6b20312e30"), std::string::npos) << told[2];  // the sketch's name
  expect_the_same_in_all_slices(BOARD, {{0, "open 0"}, {4000000, "write 0 00" + HELLO_PACKET}, {8000000, ""}});
}
