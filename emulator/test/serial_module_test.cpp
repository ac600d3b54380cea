// SPDX-License-Identifier: GPL-3.0-or-later
// Modules from UART to UART: what comes when, and what is lost.
#include "support.h"

static const std::string SENT = "0001132f2f2f2f43414645417748656c6c6f21b2bc00";
// The time of a byte at the board, in seconds: simavr counts 11 bits, at 9615 bit/s.
static const double UART_BYTE = 11 / 9615.0;

static std::string modules(const std::string &radio, const std::string &more = "",
                           const std::string &sender = "module_send") {
  return R"({"radio":{)" + radio + R"(},"boards":[{"name":"sender","firmware":"@)" + sender +
         R"("},{"name":"mirror","firmware":"@module_mirror","position":[30,40],
         "auxPin":22,"watch":[{"pin":22,"name":"aux"}]})" +
         more + "]}";
}

// All bytes that came to a board.
static std::string came_to(Emulation &run, const std::string &board) {
  run.close();
  std::string bytes;
  for (const Event &event : run.events(board, "uart")) bytes += event.text("hex");
  return bytes;
}

TEST(SerialModule, a_packet_comes_as_it_was_given_and_is_told) {
  for (const char *kind : {"hc-12", "e32", "e22"}) {
    SCOPED_TRACE(kind);
    Scratch scratch;
    Emulation run(scratch, modules("\"module\":\"" + std::string(kind) + "\""));
    run.run_until(0.35);
    auto sent = run.events("sender", "rf-tx");
    ASSERT_EQ(sent.size(), 1u);
    EXPECT_EQ(sent[0].text("payload"), HELLO);
    EXPECT_EQ(sent[0].text("content"), "Hello!");
    EXPECT_EQ(sent[0].text("radio"), kind);
    EXPECT_EQ(sent[0].number("bits"), 8 * 22);
    auto received = run.events("mirror", "rf-rx");
    ASSERT_EQ(received.size(), 1u);
    EXPECT_EQ(received[0].text("from"), "sender");
    EXPECT_EQ(received[0].real("start"), sent[0].real("start"));
    EXPECT_EQ(received[0].number("packet"), 1);
    EXPECT_EQ(sent[0].number("packet"), 1);
    EXPECT_EQ(run.e.listener.stations[1].heard, 1u);
    EXPECT_EQ(came_to(run, "mirror"), SENT);
  }
}

TEST(SerialModule, hc_12_sends_16_bytes_while_the_next_ones_come) {
  Scratch scratch;
  Emulation run(scratch, modules(R"("module":"hc-12")"));
  run.run_until(0.35);
  auto sent = run.events("rf-tx");
  ASSERT_EQ(sent.size(), 1u);
  EXPECT_NEAR(sent[0].real("start"), 0.05 + 16 * UART_BYTE + 0.005, 0.0005);
  EXPECT_NEAR(sent[0].real("end"), sent[0].real("start") + 2 * 0.0043 + 22 * 8 / 15000.0, 0.0005);
}

TEST(SerialModule, e32_sends_all_at_once_when_nothing_more_comes) {
  Scratch scratch;
  Emulation run(scratch, modules(R"("module":"e32")"));
  run.run_until(0.35);
  auto sent = run.events("rf-tx");
  ASSERT_EQ(sent.size(), 1u);
  EXPECT_NEAR(sent[0].real("start"), 0.05 + 22 * UART_BYTE + 0.0032, 0.0005);
  EXPECT_NEAR(sent[0].real("end") - sent[0].real("start"), 0.06 + 22 * 8 / 2400.0, 0.0005);
}

TEST(SerialModule, nothing_comes_out_of_range) {
  Scratch scratch;
  Emulation run(scratch, modules(R"("module":"hc-12","range":49)"));
  run.run_until(1);
  EXPECT_EQ(run.events("rf-tx").size(), 3u);
  EXPECT_TRUE(run.events("rf-rx").empty());
  EXPECT_TRUE(run.events("rf-damaged").empty());
  EXPECT_EQ(came_to(run, "mirror"), "");
}

TEST(SerialModule, what_overlaps_is_lost_and_half_a_packet_may_come) {
  Scratch scratch;
  Emulation run(scratch, modules(R"("module":"hc-12")", R"(,{"name":"other","firmware":"@module_send_later"})"));
  run.run_until(0.35);
  EXPECT_EQ(run.events("rf-tx").size(), 2u);
  EXPECT_TRUE(run.events("rf-rx").empty());
  EXPECT_GE(run.events("mirror", "rf-collision").size(), 1u);
  EXPECT_EQ(run.events("mirror", "rf-damaged").size(), 2u);
  EXPECT_EQ(run.events("sender", "rf-damaged").size(), 1u) << "it sends itself";
  EXPECT_EQ(run.events("sender", "rf-damaged")[0].number("packet"), 2);
  EXPECT_LT(came_to(run, "mirror").size(), 2 * SENT.size());
}

static std::string with_losses(uint64_t seed) {
  Scratch scratch;
  Emulation run(scratch, modules(R"("module":"e32","loss":0.4)"), seed);
  run.run_until(10);
  size_t received = run.events("rf-rx").size(), lost = run.events("rf-damaged").size();
  EXPECT_EQ(received + lost, run.events("rf-tx").size());
  EXPECT_GT(received, 5u);
  EXPECT_GT(lost, 3u);
  return run.trace_text();
}

TEST(SerialModule, losses_repeat_by_seed) {
  std::string first = with_losses(1);
  EXPECT_EQ(first, with_losses(1));
  EXPECT_NE(first, with_losses(2));
}

TEST(SerialModule, a_jam_damages_what_is_sent_meanwhile) {
  Scratch scratch;
  std::string json = modules(R"("module":"e32")");
  json.replace(json.rfind("]}"), 2, R"(],"faults":[{"t":0.1,"do":"jam","duration":0.1}]})");
  Emulation run(scratch, json);
  run.run_until(0.7);
  EXPECT_EQ(run.events("mirror", "rf-damaged").size(), 1u);
  EXPECT_EQ(run.events("mirror", "rf-rx").size(), 1u);
}

TEST(SerialModule, what_is_beyond_its_buffer_is_lost) {
  Scratch scratch;
  Emulation run(scratch, modules(R"("module":"e32","buffer":60)", "", "module_send_much"));
  run.run_until(1.2);
  EXPECT_EQ(run.e.modules.modules[0].lost > 0, true);
  EXPECT_TRUE(run.events("rf-rx").empty());
}

TEST(SerialModule, a_board_at_another_rate_gives_it_any_bytes) {
  Scratch scratch;
  Emulation run(scratch, modules(R"("module":"hc-12")", "", "module_send_fast"));
  run.run_until(0.35);
  EXPECT_TRUE(run.events("rf-tx").empty());
  EXPECT_NE(came_to(run, "mirror"), "");
}

TEST(SerialModule, holds_its_aux_low_while_it_gives_what_it_received) {
  Scratch scratch;
  Emulation run(scratch, modules(R"("module":"e32")"));
  bool low = false;
  auto aux = [&] { return (run.e.nodes[1].arduino.ports[0].external & 1) != 0; };  // pin 22 is A0
  run.run_until(0.1);
  EXPECT_TRUE(aux());
  low = run.run_while_waiting(0.3, [&] { return !aux(); });
  EXPECT_TRUE(low);
  run.run_until(0.34);
  EXPECT_TRUE(aux());
}

TEST(SerialModule, an_injected_packet_is_heard_in_range_of_where_it_stands) {
  Scratch scratch;
  Emulation run(scratch, modules(R"("module":"hc-12","range":20)"));
  EXPECT_EQ(run.command(R"({"do":"send","position":[30,30],"payload":")" + HELLO + R"(","hops":1,"distance":2})"), "");
  run.run_until(0.1);
  auto sent = run.events("injector", "rf-tx");
  ASSERT_EQ(sent.size(), 1u);
  EXPECT_EQ(sent[0].text("payload"), HELLO);
  EXPECT_EQ(sent[0].number("hops"), 1);
  EXPECT_EQ(sent[0].number("distance"), 2);
  EXPECT_EQ(run.events("mirror", "rf-rx").size(), 1u);
  EXPECT_TRUE(run.events("sender", "rf-rx").empty());
}

TEST(SerialModule, a_power_cut_ends_what_it_sends) {
  Scratch scratch;
  std::string json = modules(R"("module":"e32")");
  json.replace(json.rfind("]}"), 2, R"(],"faults":[{"t":0.1,"board":"sender","do":"power-cut","duration":1}]})");
  Emulation run(scratch, json);
  run.run_until(0.5);
  EXPECT_TRUE(run.events("rf-rx").empty());
}
