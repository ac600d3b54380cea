// SPDX-License-Identifier: GPL-3.0-or-later
// Boards and hosts: the port's life, with this process as host.
#include "support.h"

#include <fcntl.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <random>

static const char ECHO_BOARD[] = R"({"boards":[{"name":"a","firmware":"@uart_echo","port":"ports/a"}]})";

// A host that opens the port, and sets nothing.
struct Host {
  explicit Host(const std::string &path) : fd(open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK)) {}
  ~Host() { close(fd); }
  void send(const std::string &bytes) const { EXPECT_EQ(write(fd, bytes.data(), bytes.size()), (ssize_t)bytes.size()); }
  void receive() {
    char buffer[4096];
    ssize_t length = read(fd, buffer, sizeof buffer);
    if (length > 0) received.append(buffer, (size_t)length);
  }
  bool gone() const {
    struct pollfd state = {fd, POLLIN, 0};
    return poll(&state, 1, 0) == 1 && (state.revents & POLLHUP);
  }
  // Whether what it writes waits: the kernel has it do so a little later, on a busy machine much later.
  bool waits(int milliseconds) const {
    struct pollfd state = {fd, POLLOUT, 0};
    for (int i = 0; i < 10 * milliseconds && poll(&state, 1, 0) == 1; i++) usleep(100);
    return poll(&state, 1, 0) == 0;
  }
  int fd;
  std::string received;
};

static void let_boot(Emulation &run) {
  run.run_while_waiting(0.01, [] { return false; });
}

TEST(Port, every_byte_comes_back) {
  Scratch scratch;
  Emulation run(scratch, ECHO_BOARD);
  Host host(scratch.path("ports/a"));
  let_boot(run);
  std::mt19937 random(1);
  std::string bytes, waiting;
  for (int i = 0; i < 6000; i++) bytes += static_cast<char>(random());
  waiting = bytes;
  double begin = cycles_to_seconds(run.e.now);
  ASSERT_TRUE(run.run_while_waiting(2, [&] {
    ssize_t sent = write(host.fd, waiting.data(), std::min<size_t>(waiting.size(), 500));
    waiting.erase(0, sent > 0 ? (size_t)sent : 0);
    host.receive();
    return host.received.size() >= bytes.size();
  }));
  EXPECT_EQ(host.received, bytes);
  double seconds = cycles_to_seconds(run.e.now) - begin;
  EXPECT_GT(seconds, 6000 * 10 / 115200.0 * 0.95);  // not faster than the line
  EXPECT_LT(seconds, 6000 * 10 / 115200.0 * 1.5);
}

TEST(Port, opening_resets_the_board_and_opening_again_too) {
  Scratch scratch;
  Emulation run(scratch, ECHO_BOARD);
  for (int round = 0; round < 3; round++) {
    Host host(scratch.path("ports/a"));
    let_boot(run);
    host.send("x");
    EXPECT_TRUE(run.run_while_waiting(0.1, [&] {
      host.receive();
      return host.received == "x";
    }));
    close(host.fd);
    let_boot(run);
    host.fd = -1;
  }
  auto resets = run.events("a", "reset");
  ASSERT_EQ(resets.size(), 4u);
  EXPECT_EQ(resets[3].text("why"), "port opened");
  auto changes = run.events("a", "port");
  ASSERT_EQ(changes.size(), 6u);
  EXPECT_EQ(changes[0].text("state"), "open");
  EXPECT_EQ(changes[5].text("state"), "closed");
}

TEST(Port, opening_does_not_reset_where_the_scenario_says_so) {
  Scratch scratch;
  Emulation run(scratch, R"({"boards":[{"name":"a","firmware":"@uart_echo","port":"a","resetOnOpen":false}]})");
  Host host(scratch.path("a"));
  let_boot(run);
  EXPECT_EQ(run.events("a", "reset").size(), 1u);
}

TEST(Port, is_raw_without_the_host_asking) {
  Scratch scratch;
  Emulation run(scratch, ECHO_BOARD);
  Host host(scratch.path("ports/a"));
  let_boot(run);
  host.send(std::string("\x03\x04\x11\x13\r\n\0\xFF", 8));
  ASSERT_TRUE(run.run_while_waiting(0.1, [&] {
    host.receive();
    return host.received.size() >= 8;
  }));
  EXPECT_EQ(host.received, std::string("\x03\x04\x11\x13\r\n\0\xFF", 8));
}

TEST(Port, bytes_that_nobody_reads_are_dropped_and_counted_and_not_kept_for_the_next_host) {
  Scratch scratch;
  Emulation run(scratch, R"({"boards":[{"name":"a","firmware":"@uart_echo","port":"a","resetOnOpen":false}]})");
  {
    Host host(scratch.path("a"));
    let_boot(run);
    host.send("unread");
    let_boot(run);
  }
  let_boot(run);
  Host next(scratch.path("a"));
  let_boot(run);
  next.send("y");
  ASSERT_TRUE(run.run_while_waiting(0.1, [&] {
    next.receive();
    return !next.received.empty();
  }));
  EXPECT_EQ(next.received, "y");
}

TEST(Port, a_board_that_talks_to_nobody_goes_on) {
  Scratch scratch;
  Emulation run(scratch,
                R"({"boards":[{"name":"a","firmware":"@blink","port":"a","watch":[{"pin":13,"name":"led"}]}]})");
  run.run_while_waiting(0.1, [] { return false; });
  EXPECT_EQ(run.events("a", "pin").size(), 9u);
  run.close();
  EXPECT_EQ(run.events("a", "counters").at(0).number("serialDropped"), 6);
}

TEST(Port, is_taken_away_and_given_back) {
  Scratch scratch;
  std::string json = ECHO_BOARD;
  json.replace(json.rfind("}"), 1,
               R"(,"faults":[{"t":0.05,"board":"a","do":"unplug"},{"t":0.1,"board":"a","do":"plug"}]})");
  Emulation run(scratch, json);
  Host host(scratch.path("ports/a"));
  EXPECT_TRUE(run.run_while_waiting(0.2, [&] { return host.gone(); }));
  EXPECT_NEAR(cycles_to_seconds(run.e.now), 0.05, 0.002);
  EXPECT_FALSE(exists(scratch.path("ports/a")));
  EXPECT_TRUE(run.run_while_waiting(0.2, [&] { return exists(scratch.path("ports/a")); }));
  EXPECT_NEAR(cycles_to_seconds(run.e.now), 0.1, 0.002);
  Host again(scratch.path("ports/a"));
  let_boot(run);
  again.send("z");
  EXPECT_TRUE(run.run_while_waiting(0.1, [&] {
    again.receive();
    return again.received == "z";
  }));
  std::vector<std::string> states;
  for (const Event &event : run.events("a", "port")) states.push_back(event.text("state"));
  EXPECT_EQ(states, (std::vector<std::string>{"open", "unplugged", "plugged", "open"}));
}

TEST(Port, a_host_waits_while_time_stands_still) {
  Scratch scratch;
  Emulation run(scratch, ECHO_BOARD);
  const std::string FLOW = "\x11\x13x";
  for (bool comes_late : {false, true}) {
    emulation_hold(&run.e, comes_late);
    Host host(scratch.path("ports/a"));
    if (!comes_late) {
      let_boot(run);
      host.send(FLOW);
      emulation_exchange(&run.e);
      emulation_run(&run.e, run.e.now + 20 * CYCLES_PER_MS);  // the echo is on its way back
      emulation_hold(&run.e, true);
    }
    emulation_exchange(&run.e);
    EXPECT_TRUE(host.waits(30000));
    emulation_hold(&run.e, false);
    EXPECT_FALSE(host.waits(100));
    let_boot(run);
    host.send(FLOW);
    const std::string ALL = comes_late ? FLOW : FLOW + FLOW;
    run.run_while_waiting(0.1, [&] {
      host.receive();
      return host.received.size() >= ALL.size();
    });
    EXPECT_EQ(host.received, ALL);
    close(host.fd);
    let_boot(run);
    host.fd = -1;
  }
}

TEST(Port, an_exchange_brings_nothing_when_it_is_unplugged) {
  Scratch scratch;
  Emulation run(scratch, ECHO_BOARD);
  Host host(scratch.path("ports/a"));
  let_boot(run);
  host.send("zz");
  const pty &port = run.e.nodes[0].port;
  EXPECT_TRUE(run.run_while_waiting(0.1, [&] { return port.gave > 0; }));
  EXPECT_EQ(run.command(R"({"do":"unplug","board":"a"})"), "");
  emulation_exchange(&run.e);
  EXPECT_EQ(port.got + port.gave, 0u);
}

TEST(Port, the_symlink_replaces_a_stale_one_and_goes_at_the_end) {
  Scratch scratch;
  ASSERT_EQ(symlink("/dev/pts/99999", scratch.path("a").c_str()), 0);
  {
    Emulation run(scratch, R"({"boards":[{"name":"a","firmware":"@uart_echo","port":"a"}]})");
    Host host(scratch.path("a"));
    EXPECT_GE(host.fd, 0);
  }
  EXPECT_FALSE(exists(scratch.path("a")));
}

TEST(Port, what_is_no_symlink_is_left_alone) {
  Scratch scratch;
  std::string path = scratch.write("a", "precious");
  pty p = {};
  p.master = -1;
  char error[512];
  EXPECT_EQ(pty_plug(&p, path.c_str(), error, sizeof error), -1);
  EXPECT_EQ(error, "port " + path + ": there is something that is no symlink; remove it or choose another path");
  EXPECT_EQ(read_text(path), "precious");
}

// A board whose bridge has a latency of 16 ms; what `more` adds is at the scenario's end.
static std::string bridged(const std::string &program, const std::string &more = "") {
  return R"({"boards":[{"name":"a","firmware":"@)" + program + R"(","port":"a","bridge":{"latency":16}}])" + more + "}";
}

// Waits for the kernel, without emulated time going on. False where nothing comes.
static bool readable(int fd) {
  struct pollfd state = {fd, POLLIN, 0};
  return poll(&state, 1, 60000) == 1;
}

// Sends bytes, and lets all of them reach the port before time goes on.
static void let_arrive(Emulation &run, const Host &host, const std::string &bytes) {
  const pty &port = run.e.nodes[0].port;
  uint64_t received = port.received + bytes.size();
  host.send(bytes);
  while (port.received < received && readable(port.master)) emulation_exchange(&run.e);
  EXPECT_EQ(port.received, received);
}

// Runs until the port passes something on. Returns the time since `from`, in milliseconds.
static double next_packet(Emulation &run, cycles_t from = 0) {
  uint64_t sent = run.e.nodes[0].port.sent;
  EXPECT_TRUE(run.run_while_waiting(0.1, [&] { return run.e.nodes[0].port.sent > sent; }));
  return static_cast<double>(run.e.now - from) / CYCLES_PER_MS;
}

static std::string received(Host &host, size_t length) {
  while (host.received.size() < length && readable(host.fd)) host.receive();
  return host.received;
}

TEST(PortBridge, holds_bytes_back_until_its_timer_ends) {
  Scratch scratch;
  Emulation run(scratch, bridged("blink"));
  Host host(scratch.path("a"));
  let_boot(run);                                         // the line takes 6 ms
  EXPECT_EQ(run.e.nodes[0].line.from_board.length, 6u);  // the trace sees the board's side
  EXPECT_EQ(run.e.nodes[0].port.sent, 0u);
  EXPECT_EQ(next_packet(run), 16);
  EXPECT_EQ(received(host, 6), "blink\n");
}

TEST(PortBridge, passes_long_data_on_in_full_packets) {
  Scratch scratch;
  Emulation run(scratch, bridged("uart_echo"));
  Host host(scratch.path("a"));
  let_arrive(run, host, std::string(200, 'x'));
  for (uint64_t sent : {62u, 124u, 186u}) {
    next_packet(run);
    EXPECT_EQ(run.e.nodes[0].port.sent, sent);
  }
  EXPECT_EQ(next_packet(run, run.e.now), 16);
  EXPECT_EQ(run.e.nodes[0].port.sent, 200u);
  EXPECT_EQ(received(host, 200), std::string(200, 'x'));
}

TEST(PortBridge, starts_its_timer_when_the_port_is_opened) {
  Scratch scratch;
  Emulation run(scratch, bridged("uart_echo"));
  run.run_while_waiting(0.005, [] { return false; });
  Host host(scratch.path("a"));
  let_arrive(run, host, "x");
  EXPECT_EQ(next_packet(run), 5 + 16);
}

TEST(PortBridge, keeps_nothing_for_the_next_host) {
  Scratch scratch;
  Emulation run(scratch, bridged("uart_echo"));
  {
    Host host(scratch.path("a"));
    let_arrive(run, host, "held");
    let_boot(run);
  }
  let_boot(run);
  EXPECT_EQ(run.e.nodes[0].port.dropped, 4u);
  Host next(scratch.path("a"));
  let_arrive(run, next, "y");
  next_packet(run);
  EXPECT_EQ(received(next, 1), "y");
  EXPECT_EQ(run.e.nodes[0].port.sent, 1u);
}

TEST(PortBridge, loses_what_it_holds_with_the_power_but_not_by_a_reset) {
  Scratch scratch;
  Emulation run(scratch, bridged("blink", R"(,"faults":[{"t":0.008,"board":"a","do":"reset"},)"
                                          R"({"t":0.020,"board":"a","do":"reset"},)"
                                          R"({"t":0.028,"board":"a","do":"power-cut","duration":0.01}])"));
  Host host(scratch.path("a"));
  EXPECT_EQ(next_packet(run), 16);
  EXPECT_EQ(received(host, 12), "blink\nblink\n");
  EXPECT_TRUE(run.run_while_waiting(0.1, [&] { return host.gone(); }));
  EXPECT_EQ(run.e.nodes[0].port.dropped, 6u);
  EXPECT_TRUE(run.run_while_waiting(0.1, [&] { return exists(scratch.path("a")); }));
  cycles_t opened = run.e.now;
  Host again(scratch.path("a"));
  EXPECT_EQ(next_packet(run, opened), 16);
  EXPECT_EQ(received(again, 6), "blink\n");
}
