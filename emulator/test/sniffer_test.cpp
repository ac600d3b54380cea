// SPDX-License-Identifier: GPL-3.0-or-later
// What the trace says of packets, given to the sniffer bit by bit.
#include "support.h"

#include <memory>

namespace {

uint16_t crc(const std::string &bytes) {
  uint16_t value = 0xFFFF;
  for (unsigned char byte : bytes) {
    value ^= byte;
    for (int bit = 0; bit < 8; bit++) value = static_cast<uint16_t>(value & 1 ? value >> 1 ^ 0x8408 : value >> 1);
  }
  return static_cast<uint16_t>(~value);
}

// SPEC section 6.
std::string line_bits(const std::string &payload) {
  static const int SYMBOLS[] = {0x0D, 0x0E, 0x13, 0x15, 0x16, 0x19, 0x1A, 0x1C,
                                0x23, 0x25, 0x26, 0x29, 0x2A, 0x2C, 0x32, 0x34};
  std::string bytes = static_cast<char>(payload.size() + 3) + payload;
  uint16_t check = crc(bytes);
  bytes += static_cast<char>(check & 0xFF);
  bytes += static_cast<char>(check >> 8);
  std::vector<int> symbols = {0x2A, 0x2A, 0x2A, 0x2A, 0x2A, 0x2A, 0x38, 0x2C};
  for (unsigned char byte : bytes) {
    symbols.push_back(SYMBOLS[byte >> 4]);
    symbols.push_back(SYMBOLS[byte & 15]);
  }
  std::string bits;
  for (int symbol : symbols)
    for (int bit = 0; bit < 6; bit++) bits += symbol >> bit & 1 ? '1' : '0';
  return bits;
}

Event sniffed(const std::string &payload) {
  static std::vector<std::unique_ptr<Emulation>> runs;  // events refer to them
  Scratch scratch;
  runs.emplace_back(new Emulation(scratch, R"({"boards":[{"name":"a","firmware":"@blink"}]})"));
  sniffer *listener = &runs.back()->e.listener;
  const cycles_t bit = CYCLES_PER_SECOND / 2000;
  cycles_t at = CYCLES_PER_MS;
  for (char level : line_bits(payload) + "0") {
    sniffer_tx_edge(listener, 0, level == '1', at);
    at += bit;
  }
  sniffer_advance_tx(listener, at + 20 * bit);
  auto sent = runs.back()->events("rf-tx");
  return sent.size() == 1 ? sent[0] : Event{};
}

}  // namespace

// A jam that begins just before the last bit has a receiver read that bit up to half a bit early.
TEST(Sniffer, tells_that_a_packet_was_sent_before_it_tells_that_it_was_heard) {
  std::string bits;
  for (char last = 'a'; bits.empty() || bits.substr(bits.size() - 2) != "01"; last++)
    bits = line_bits(std::string("////CAFEAwHello") + last);
  Scratch scratch;
  Emulation run(scratch, R"({"boards":[{"name":"a","firmware":"@blink"},{"name":"b","firmware":"@blink"}]})");
  sniffer *listener = &run.e.listener;
  const cycles_t bit = CYCLES_PER_SECOND / 2000;
  cycles_t at = CYCLES_PER_MS;
  for (size_t i = 0; i < bits.size(); i++, at += bit) {
    sniffer_tx_edge(listener, 0, bits[i] == '1', at);
    if (i + 1 < bits.size()) sniffer_rx_edge(listener, 1, bits[i] == '1', at + RF_DELAY);
  }
  const cycles_t jam = at - bit - bit / 4;
  sniffer_rx_edge(listener, 1, true, jam);
  const cycles_t heard = jam + bit / 2 + 1;
  sniffer_advance_tx(listener, heard);
  sniffer_advance_rx(listener, heard);
  ASSERT_EQ(run.events("rf-rx").size(), 1u);
  EXPECT_EQ(run.events("rf-rx")[0].text("from"), "a");
  sniffer_tx_edge(listener, 0, false, at);
  sniffer_advance_tx(listener, at + 20 * bit);
  sniffer_advance_rx(listener, at + 20 * bit);
  EXPECT_EQ(run.events("rf-tx").size(), 1u);
  EXPECT_TRUE(run.events("rf-damaged").empty());
}

TEST(Sniffer, tells_content_in_the_clear) {
  Event event = sniffed("////CAFEAwHello!");
  EXPECT_EQ(event.text("kind"), "broadcast");
  EXPECT_EQ(event.text("content"), "Hello!");
  EXPECT_NE(json_object_get(event.fields, "sealed"), nullptr);
}

TEST(Sniffer, tells_a_piece_and_whether_it_asks) {
  Event event = sniffed("+FCKCAFEAwHello!");
  EXPECT_EQ(event.text("kind"), "piece");
  EXPECT_EQ(event.text("origin"), "CAFE");
  EXPECT_EQ(event.number("id"), 2);
  EXPECT_EQ(event.number("index"), 2);
  EXPECT_TRUE(event.flag("asks"));
  EXPECT_FALSE(sniffed("+FCCCAFEAwHello!").flag("asks"));
}

TEST(Sniffer, calls_a_part_of_a_message_no_content) {
  EXPECT_EQ(json_object_get(sniffed("+FCCCAFEAwHello!").fields, "content"), nullptr);
  EXPECT_EQ(json_object_get(sniffed("+KCCCAFEBA12345678").fields, "content"), nullptr);
}

TEST(Sniffer, tells_what_an_acknowledgement_answers) {
  EXPECT_EQ(sniffed("+KABCAFEBA12345678").text("kind"), "acknowledgement");
  EXPECT_EQ(sniffed("+KABCAFEBA12345678").text("answers"), "delivered");
  EXPECT_EQ(sniffed("+KABCAFEBI123456789").text("answers"), "pieces");
  EXPECT_EQ(sniffed("+KABCAFECA1234567890123456").text("answers"), "stale");
  EXPECT_EQ(sniffed("+KABCAFEAA").text("answers"), "unknown");
}

TEST(Sniffer, tells_what_is_reserved_and_what_is_no_frame) {
  EXPECT_EQ(sniffed("+GABCAFEAwHello!").text("kind"), "reserved");
  EXPECT_EQ(sniffed("Hello!").text("kind"), "no frame");
}
