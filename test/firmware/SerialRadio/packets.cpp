#include <gtest/gtest.h>
#include <serialradio/SerialRadio.h>

#include "support/FakeClock.h"
#include "support/FakeUart.h"
#include "support/Reference.h"
#include "support/Vectors.h"

namespace {

class SerialRadioPackets : public testing::Test {
 protected:
  SerialRadioPackets() { radio.begin(); }

  // The bytes that the radio gives to its module, however slowly that takes it.
  Bytes sent(const Bytes &payload, size_t bytesAtOnce) {
    EXPECT_TRUE(radio.send(payload.data(), static_cast<uint8_t>(payload.size())));
    Bytes all;
    while (radio.sending()) {
      receive();
      all = all + uart.take(bytesAtOnce);
      clock.millis++;
    }
    return all + uart.take();
  }

  Bytes receive() {
    const uint8_t *payload = radio.receive(with);
    return payload ? Bytes(payload, payload + with.length) : Bytes();
  }

  // The payloads that come of these bytes, given in portions.
  std::vector<Bytes> received(const Bytes &bytes, size_t portion) {
    std::vector<Bytes> payloads;
    for (size_t at = 0; at < bytes.size(); at += portion) {
      uart.arrive(Bytes(bytes.begin() + at, bytes.begin() + std::min(bytes.size(), at + portion)));
      for (Bytes payload = receive(); !payload.empty(); payload = receive()) {
        payloads.push_back(payload);
        radio.release();
      }
    }
    return payloads;
  }

  javinolib::RadioCounters counters() const {
    javinolib::RadioCounters counters;
    radio.counters(counters);
    return counters;
  }

  FakeClock clock;
  FakeUart uart;
  javinolib::Received with;
  javinolib::SerialRadio radio{uart, JAVINO_HC_12};
};

const Bytes FRAME = reference::frame("////", "CAFE", bytesOf("tell;help"));

}  // namespace

TEST_F(SerialRadioPackets, gives_its_module_all_valid_vectors) {
  for (const Vector &vector : vectors("modules.json", "valid")) {
    SCOPED_TRACE(vector.toString());
    *radio.sentPath() = static_cast<uint8_t>(vector.number("path"));
    for (size_t atOnce : {1, 7, 63}) EXPECT_EQ(vector.text("sent"), toHex(sent(vector.bytes("payload"), atOnce)));
  }
}

TEST_F(SerialRadioPackets, takes_all_valid_vectors_in_portions_of_each_size) {
  for (const Vector &vector : vectors("modules.json", "valid")) {
    SCOPED_TRACE(vector.toString());
    for (size_t portion = 1; portion < FakeUart::ROOM; portion++) {
      ASSERT_EQ(std::vector<Bytes>{vector.bytes("payload")}, received(vector.bytes("sent"), portion));
      ASSERT_EQ(vector.number("path"), with.path);
    }
  }
  EXPECT_EQ(0u, counters().damaged);
}

TEST_F(SerialRadioPackets, refuses_and_counts_all_invalid_vectors) {
  uint32_t damaged = 0;
  for (const Vector &vector : vectors("modules.json", "invalid")) {
    SCOPED_TRACE(vector.toString());
    EXPECT_TRUE(received(vector.bytes("sent"), 1).empty());
    EXPECT_EQ(++damaged, counters().damaged);
  }
  EXPECT_EQ(0u, counters().received);
}

TEST_F(SerialRadioPackets, takes_no_more_than_its_module_sends_at_once) {
  javinolib::SerialRadio e32(uart, JAVINO_E32);
  const Bytes longest = reference::frame("CAFE", "ROMA", Bytes(42, 1));
  EXPECT_EQ(52, e32.longestPayload());
  EXPECT_FALSE(e32.send(longest.data(), 53));
  ASSERT_TRUE(e32.send(longest.data(), 52));
  EXPECT_EQ(58u, uart.take().size());
  uart.arrive(reference::packet(0, longest));
  EXPECT_NE(nullptr, e32.receive(with));
  e32.release();
  uart.arrive(reference::packet(0, reference::frame("CAFE", "ROMA", Bytes(43, 1))));
  EXPECT_EQ(nullptr, e32.receive(with));
}

TEST_F(SerialRadioPackets, finds_the_packet_behind_one_that_lost_any_of_its_bytes) {
  const Bytes packet = Bytes{0} + reference::packet(0, FRAME);
  for (size_t from = 0; from < packet.size(); from++) {
    for (size_t until = from + 1; until <= packet.size(); until++) {
      const Bytes holed = Bytes(packet.begin(), packet.begin() + from) + Bytes(packet.begin() + until, packet.end());
      const std::vector<Bytes> payloads = received(holed + packet, 40);
      ASSERT_FALSE(payloads.empty());
      ASSERT_EQ(FRAME, payloads.back()) << from << "…" << until;
    }
  }
}

TEST_F(SerialRadioPackets, any_bytes_give_packets_with_a_right_crc_only_and_the_next_one_is_found) {
  RandomBytes random(7);
  for (int i = 0; i < 2000; i++) {
    Bytes bytes = random.bytes(random.number(60));
    for (uint8_t &byte : bytes) byte = random.number(3) == 0 ? static_cast<uint8_t>(random.number(16)) : byte;
    ASSERT_TRUE(received(bytes, 1 + random.number(20)).empty());
    ASSERT_EQ(std::vector<Bytes>{FRAME}, received(Bytes{0} + reference::packet(1, FRAME), 1 + random.number(20)));
  }
}

TEST_F(SerialRadioPackets, keeps_the_next_packet_in_the_port_until_the_first_is_released) {
  const Bytes packet = reference::packet(0, FRAME);
  uart.arrive(packet + reference::packet(2, FRAME));
  EXPECT_EQ(FRAME, receive());
  EXPECT_EQ(FRAME, receive());
  EXPECT_EQ(0, with.path);
  EXPECT_FALSE(radio.idle());
  radio.release();
  EXPECT_EQ(FRAME, receive());
  EXPECT_EQ(2, with.path);
  radio.release();
  EXPECT_TRUE(radio.idle());
  EXPECT_EQ(2u, counters().received);
}

TEST_F(SerialRadioPackets, counts_as_missed_what_the_port_had_no_room_for) {
  const Bytes packet = reference::packet(0, FRAME);
  EXPECT_EQ((std::vector<Bytes>{FRAME, FRAME}), received(packet + packet + packet, 100));
  EXPECT_EQ(std::vector<Bytes>{FRAME}, received(packet + packet, 10));
  EXPECT_EQ(1u, counters().missed);
  EXPECT_EQ(0u, counters().damaged);
}
