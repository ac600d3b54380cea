// SPDX-License-Identifier: GPL-3.0-or-later
// The trace of packets that the sniffer is given bit by bit.
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

Event sniffed_bits(const std::string &bits) {
  static std::vector<std::unique_ptr<Emulation>> runs;  // events refer to them
  Scratch scratch;
  runs.emplace_back(new Emulation(scratch, R"({"boards":[{"name":"a","firmware":"@blink"}]})"));
  sniffer *listener = &runs.back()->e.listener;
  cycles_t at = CYCLES_PER_MS;
  for (char level : bits + "0") {
    sniffer_tx_edge(listener, 0, level == '1', at);
    at += BIT;
  }
  sniffer_advance_tx(listener, at + 20 * BIT);
  auto sent = runs.back()->events("rf-tx");
  return sent.size() == 1 ? sent[0] : Event{};
}

Event sniffed(const std::string &payload) { return sniffed_bits(line_bits(payload)); }

const std::string PAYLOAD = "CAFEROMAAwHello!";
const int PACKET_BITS = 84 + 12 * 16;
const std::string MARK = "001110110001";
const std::string PARITY = "110001001110";

// Parity of so many bytes: whatever they are, their symbols are those of SPEC 6.1.
std::string parity_bits(int bytes) {
  std::string bits;
  for (int i = 0; i < bytes; i++) bits += i % 2 ? "111000001011" : "101100001110";
  return bits;
}

// The trailer that the carrier shows behind a packet, and how long the packet is to be on the air.
void expect_trailer(const std::string &payload, const std::string &behind, const std::string &trailer, size_t bits) {
  const std::string packet = line_bits(payload);
  Event event = sniffed_bits(packet + behind);
  EXPECT_EQ(event.text("trailer"), trailer) << behind;
  EXPECT_EQ(static_cast<size_t>(event.number("bits")), packet.size() + bits) << behind;
  // The first bit is a 0.
  EXPECT_NEAR((event.real("end") - event.real("start")) * 2000, static_cast<double>(packet.size() + bits - 1), 0.01)
      << behind;
  EXPECT_EQ(event.t, event.real("end"));
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
  cycles_t at = CYCLES_PER_MS;
  for (size_t i = 0; i < bits.size(); i++, at += BIT) {
    sniffer_tx_edge(listener, 0, bits[i] == '1', at);
    if (i + 1 < bits.size()) sniffer_rx_edge(listener, 1, bits[i] == '1', at + RF_DELAY);
  }
  sniffer_rx_edge(listener, 1, true, at - BIT - BIT / 4);
  sniffer_tx_edge(listener, 0, false, at);
  for (int i = 0; i < 20; i++, at += BIT / 2) {
    sniffer_advance_tx(listener, at);
    sniffer_advance_rx(listener, at);
  }
  ASSERT_EQ(run.events("rf-rx").size(), 1u);
  EXPECT_EQ(run.events("rf-rx")[0].text("from"), "a");
  ASSERT_EQ(run.events("rf-tx").size(), 1u);
  EXPECT_LT(run.trace_text().find("rf-tx"), run.trace_text().find("rf-rx"));
  EXPECT_TRUE(run.events("rf-damaged").empty());
}

TEST(Sniffer, counts_a_trailer_to_its_packet) {
  expect_trailer(PAYLOAD, "", "", 0);
  expect_trailer(PAYLOAD, MARK, "mark", 12);
  expect_trailer(PAYLOAD, PARITY + parity_bits(12), "parity", 156);
  expect_trailer(std::string(45, 'x'), PARITY + parity_bits(16), "parity", 156);
  expect_trailer(std::string(46, 'x'), PARITY + parity_bits(16), "parity", 204);
}

// A board that loses power or is reset breaks off.
TEST(Sniffer, counts_of_a_trailer_that_was_cut_off_the_symbols_that_were_sent) {
  const std::string parity = PARITY + parity_bits(12);
  for (size_t sent = 0; sent < MARK.size(); sent++) {
    for (bool is_mark : {true, false}) {
      const std::string &word = is_mark ? MARK : PARITY;
      const size_t missing = word.find('1', sent);
      if (missing == std::string::npos) continue;
      const bool tells = missing >= 6;  // the first symbol is whole
      expect_trailer(PAYLOAD, word.substr(0, sent), !tells ? "" : is_mark ? "mark" : "parity", tells ? 6 : 0);
    }
  }
  for (size_t sent = 12; sent < parity.size(); sent++) {
    const size_t missing = parity.find('1', sent);
    if (missing == std::string::npos) continue;
    expect_trailer(PAYLOAD, parity.substr(0, sent), "parity", missing / 6 * 6);
  }
}

TEST(Sniffer, calls_nothing_else_a_trailer) {
  expect_trailer(PAYLOAD, "1", "", 0);
  expect_trailer(PAYLOAD, "001111110001", "", 0);
  expect_trailer(PAYLOAD, "110011001110", "", 0);
  // Only their first symbols are those of trailers.
  expect_trailer(PAYLOAD, "001110110011", "mark", 6);
  expect_trailer(PAYLOAD, "110001001111", "parity", 6);
  // 16, which is no symbol of trailers.
  expect_trailer(PAYLOAD, PARITY + "101100" + "011010" + parity_bits(11), "parity", 18);
}

// A receiver has the packet with its CRC; a hit on its trailer does it no harm.
TEST(Sniffer, tells_that_a_packet_was_heard_whose_trailer_was_hit) {
  Scratch scratch;
  Emulation run(scratch, R"({"boards":[{"name":"a","firmware":"@blink"},{"name":"b","firmware":"@blink"}]})");
  sniffer *listener = &run.e.listener;
  const std::string bits = line_bits(PAYLOAD) + PARITY + parity_bits(12) + "0";
  cycles_t at = CYCLES_PER_MS;
  for (size_t i = 0; i < bits.size(); i++, at += BIT) {
    sniffer_tx_edge(listener, 0, bits[i] == '1', at);
    sniffer_rx_edge(listener, 1, bits[i] == '1' || i > static_cast<size_t>(PACKET_BITS), at + RF_DELAY);
    sniffer_advance_tx(listener, at);
    sniffer_advance_rx(listener, at);
  }
  sniffer_advance_tx(listener, at + 20 * BIT);
  sniffer_advance_rx(listener, at + 20 * BIT);
  ASSERT_EQ(run.events("rf-tx").size(), 1u);
  ASSERT_EQ(run.events("rf-rx").size(), 1u);
  const Event heard = run.events("rf-rx")[0];
  EXPECT_EQ(heard.text("from"), "a");
  EXPECT_EQ(heard.number("bits"), PACKET_BITS);
  EXPECT_EQ(heard.text("trailer"), "");
  EXPECT_LT(heard.t, run.events("rf-tx")[0].t - 0.07);
  EXPECT_TRUE(run.events("rf-damaged").empty());
}

TEST(Sniffer, tells_at_the_end_what_was_sent_of_a_packet_that_was_heard) {
  Scratch scratch;
  Emulation run(scratch, R"({"boards":[{"name":"a","firmware":"@blink"},{"name":"b","firmware":"@blink"}]})");
  const std::string bits = line_bits(PAYLOAD) + PARITY + parity_bits(4).substr(0, 45);
  cycles_t at = CYCLES_PER_MS;
  for (char level : bits) {
    sniffer_tx_edge(&run.e.listener, 0, level == '1', at);
    sniffer_rx_edge(&run.e.listener, 1, level == '1', at + RF_DELAY);
    at += BIT;
  }
  sniffer_advance_tx(&run.e.listener, at);
  sniffer_advance_rx(&run.e.listener, at);
  EXPECT_TRUE(run.events("rf-tx").empty());
  ASSERT_EQ(run.events("rf-rx").size(), 1u);
  run.close();
  ASSERT_EQ(run.events("rf-tx").size(), 1u);
  const Event sent = run.events("rf-tx")[0];
  EXPECT_EQ(sent.text("trailer"), "parity");
  EXPECT_EQ(sent.number("bits"), PACKET_BITS + 12 + 42);
  EXPECT_NEAR((sent.real("end") - sent.real("start")) * 2000, PACKET_BITS + 12 + 42 - 1, 0.01);
}

TEST(Sniffer, tells_content_in_the_clear) {
  Event event = sniffed("////CAFEAwHello!");
  EXPECT_EQ(event.text("kind"), "broadcast");
  EXPECT_EQ(event.text("content"), "Hello!");
  EXPECT_NE(json_object_get(event.fields, "sealed"), nullptr);
}

TEST(Sniffer, tells_a_fragment_and_whether_it_asks) {
  Event event = sniffed("+FCKCAFEAwHello!");
  EXPECT_EQ(event.text("kind"), "fragment");
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
  EXPECT_EQ(sniffed("+KABCAFEBI123456789").text("answers"), "fragments");
  EXPECT_EQ(sniffed("+KABCAFECA1234567890123456").text("answers"), "stale");
  EXPECT_EQ(sniffed("+KABCAFEAA").text("answers"), "unknown");
}

TEST(Sniffer, tells_what_is_reserved_and_what_is_no_frame) {
  EXPECT_EQ(sniffed("+GABCAFEAwHello!").text("kind"), "reserved");
  EXPECT_EQ(sniffed("Hello!").text("kind"), "no frame");
}

// One of 276 bits that begins 100 bits before the hour is over.
TEST(Sniffer, tells_the_airtime_of_each_hour) {
  Scratch scratch;
  Emulation run(scratch, R"({"boards":[{"name":"a","firmware":"@blink"},{"name":"b","firmware":"@blink"}]})");
  sniffer *listener = &run.e.listener;
  cycles_t at = (cycles_t)3600 * CYCLES_PER_SECOND - 100 * BIT;
  for (char level : line_bits(PAYLOAD) + "0") {
    sniffer_tx_edge(listener, 0, level == '1', at);
    at += BIT;
  }
  sniffer_advance_tx(listener, at + 20 * BIT);
  run.close();
  EXPECT_NE(run.trace_text().find(R"("airtime":[0.05,0.088]})"), std::string::npos);
  auto quiet = run.events("b", "counters");
  ASSERT_EQ(quiet.size(), 1u);
  EXPECT_EQ(json_object_get(quiet[0].fields, "airtime"), nullptr) << "it has sent nothing";
}
