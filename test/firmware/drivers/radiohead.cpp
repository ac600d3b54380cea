// JavinoRadioHead over a driver whose mode and packets the test sets, as those of chips with interrupts.
#include <gtest/gtest.h>

#define Serial SimulatorsSerial
#include "JavinoRadioHead.h"
#undef Serial
#include "support/Bytes.h"
#include "support/FakeClock.h"

// What RadioHead's base class names, and no driver here calls.
SerialSimulator SimulatorsSerial;
unsigned long simulatorsMillis() { return 0; }
void delay(unsigned long) {}
long random(long from, long) { return from; }

namespace {

class ChipDriver : public RHGenericDriver {
 public:
  bool init() override {
    setMode(RHModeIdle);
    return starts;
  }
  bool available() override {
    if (mode() != RHModeTx) setMode(RHModeRx);
    return !came.empty();
  }
  bool recv(uint8_t *into, uint8_t *length) override {
    *length = std::min(*length, static_cast<uint8_t>(came.size()));
    std::copy(came.begin(), came.begin() + *length, into);
    came.clear();
    return true;
  }
  bool send(const uint8_t *payload, uint8_t length) override {
    sent.assign(payload, payload + length);
    if (tellsMode) setMode(RHModeTx);
    return true;
  }
  uint8_t maxMessageLength() override { return 60; }
  uint8_t headerId() override { return cameWith; }
  void setHeaderId(uint8_t id) override { sentWith = id; }
  int8_t rssiRead() { return dbm; }

  bool starts = true, tellsMode = true;
  Bytes sent, came;
  uint8_t sentWith = 0xFF, cameWith = 0;
  int8_t dbm = -100;
};

class JavinoRadioHeadTest : public testing::Test {
 protected:
  JavinoRadioHeadTest() { EXPECT_TRUE(radio.begin()); }

  const uint8_t *receive() {
    const uint8_t *const payload = radio.receive(with);
    return payload;
  }

  bool send(const Bytes &payload) { return radio.send(payload.data(), static_cast<uint8_t>(payload.size())); }

  FakeClock clock;
  ChipDriver driver;
  JavinoRadioHead radio{driver, JavinoAirRate::fsk(1000)};
  javinolib::Received with;
};

}  // namespace

TEST_F(JavinoRadioHeadTest, sends_the_path_as_id_until_the_driver_has_ended) {
  *radio.sentPath() = 7;
  ASSERT_TRUE(send({1, 2}));
  EXPECT_EQ((Bytes{1, 2}), driver.sent);
  EXPECT_EQ(7, driver.sentWith);
  EXPECT_FALSE(send({3}));
  receive();
  EXPECT_TRUE(radio.sending());
  driver.setMode(RHGenericDriver::RHModeIdle);
  receive();
  EXPECT_FALSE(radio.sending());
  EXPECT_EQ(RHGenericDriver::RHModeRx, driver.mode());
}

TEST_F(JavinoRadioHeadTest, sends_for_a_packets_airtime_if_the_driver_tells_no_end) {
  driver.tellsMode = false;
  ASSERT_TRUE(send({1, 2}));
  clock.millis += radio.airtimeMillis(2) - 1u;
  receive();
  EXPECT_TRUE(radio.sending());
  clock.millis++;
  receive();
  EXPECT_FALSE(radio.sending());
}

TEST_F(JavinoRadioHeadTest, listens_again_if_the_end_of_a_packet_was_lost) {
  ASSERT_TRUE(send({1, 2}));
  clock.millis += 2u * radio.airtimeMillis(2);
  receive();
  EXPECT_FALSE(radio.sending());
  EXPECT_EQ(RHGenericDriver::RHModeRx, driver.mode());
}

TEST_F(JavinoRadioHeadTest, receives_with_the_path_and_drops_what_is_too_long_or_foreign) {
  driver.came = {1, 2, 3};
  driver.cameWith = 5;
  const uint8_t *const payload = receive();
  ASSERT_NE(nullptr, payload);
  EXPECT_EQ(1, *payload);
  EXPECT_EQ(3, with.length);
  EXPECT_EQ(5, with.path);
  driver.came = {4};
  EXPECT_EQ(payload, receive());  // until it is released
  radio.release();
  EXPECT_NE(nullptr, receive());
  radio.release();
  for (uint8_t path : {0, 20}) {
    driver.came = Bytes(path == 0 ? 61 : 3, 1);
    driver.cameWith = path;
    EXPECT_EQ(nullptr, receive());
  }
  javinolib::RadioCounters counters;
  radio.counters(counters);
  EXPECT_EQ(2u, counters.received);
  EXPECT_EQ(2u, counters.damaged);
}

TEST_F(JavinoRadioHeadTest, hears_what_is_stronger_than_noise) {
  receive();
  EXPECT_FALSE(radio.carrier());
  driver.dbm = -80;
  EXPECT_TRUE(radio.carrier());
  driver.dbm = -100;
  EXPECT_TRUE(radio.carrier());  // since the last call
  EXPECT_FALSE(radio.carrier());
}

TEST(JavinoRadioHead, does_not_begin_without_its_chip) {
  FakeClock clock;
  ChipDriver driver;
  driver.starts = false;
  EXPECT_FALSE(JavinoRadioHead(driver, JavinoAirRate::fsk(1000)).begin());
}
