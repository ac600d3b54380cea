// Boards over JavinoRadioLib: RadioLib's driver of an SX1278, on emulated chips.
#include <delivery/Relay.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "JavinoRadioLib.h"
#include "LoRaChip.h"
#include "support/Keys.h"
#include "support/TestBoard.h"

using javinolib::AirRate;
using javinolib::Counter;
using javinolib::RadioLibRadio;
using testing::ElementsAre;

namespace {

struct Settings {
  float kilohertz;
  uint8_t spreading, coding;
};

void PrintTo(const Settings &settings, std::ostream *out) {
  *out << "SF" << int{settings.spreading} << " at " << settings.kilohertz << " kHz, 4/" << int{settings.coding};
}

// 22 kbit/s, 5.5 kbit/s and 293 bit/s.
const Settings FAST = {500, 7, 5}, USUAL = {125, 7, 5}, SLOW = {125, 12, 5};

// An SX1278 at a board's pins. The number tells boards apart.
template <uint8_t number>
struct Chip {
  Chip(LoRaAir &air, const Settings &settings)
      : hardware(air),
        module(&hardware, EMULATED_RADIO_NSS_PIN, EMULATED_RADIO_IRQ_PIN, EMULATED_RADIO_RST_PIN),
        driver(&module),
        radio(driver) {
    begun = driver.begin(433.5f, settings.kilohertz, settings.spreading, settings.coding);
  }

  LoRaChip hardware;
  Module module;
  SX1278 driver;
  javinolib::NumberedRadioLibRadio<number> radio;
  int16_t begun;
};

class RadioLibTest : public testing::TestWithParam<Settings> {
 protected:
  explicit RadioLibTest(const Settings &settings = GetParam())
      : romaChip(air, settings),
        supoChip(air, settings),
        thirdChip(air, settings),
        roma(&romaChip.radio),
        supo(&supoChip.radio) {
    EXPECT_EQ(RADIOLIB_ERR_NONE, romaChip.begun);
    roma.start("ROMA");
    roma.setKey("SUPO", KEY);
    supo.use();
    supo.start("SUPO");
    supo.setKey("ROMA", KEY);
    pass(5000);
  }

  void pass(uint32_t millis) {
    for (; millis != 0; millis--) {
      air.pass(1);
      for (TestBoard *board : {&roma, &supo}) {
        board->use();
        board->pass(1);
      }
      if (!relay) continue;
      relaysClock->use();
      relaysClock->millis++;
      relay->run();
    }
  }

  void beginRelay() {
    relaysClock.reset(new FakeClock);
    relay.reset(::new javinolib::Relay(thirdChip.radio));
    ASSERT_TRUE(relay->begin());
    air.reaches = [this](const LoRaChip *from, const LoRaChip *to) {
      return from == &thirdChip.hardware || to == &thirdChip.hardware;
    };
  }

  void send(const std::string &to, const std::string &content) {
    roma.use();
    EXPECT_EQ(javinolib::Status::OK, roma.transmit(to, "ROMA", content).status);
  }

  // What SUPO's host gets, which polls until it has so many or for two minutes.
  std::vector<std::string> received(size_t count = 1) {
    std::vector<std::string> contents;
    for (int polls = 0; polls < 1200 && contents.size() < count; polls++) {
      pass(100);
      supo.use();
      for (const PolledMessage &message : supo.messages()) {
        contents.push_back(message.content);
        supo.pollTaking(message.number);
      }
    }
    return contents;
  }

  std::vector<std::string> outcomes() {
    for (int polls = 0; polls < 600; polls++) {
      pass(100);
      roma.use();
      const std::vector<std::string> outcomes = roma.poll().texts('T');
      if (!outcomes.empty()) return outcomes;
    }
    return {};
  }

  static uint32_t counter(TestBoard &board, Counter counter) {
    board.use();
    return board.counter(counter);
  }

  LoRaAir air;
  Chip<0> romaChip;
  Chip<1> supoChip;
  Chip<2> thirdChip;
  TestBoard roma, supo;
  std::unique_ptr<FakeClock> relaysClock;
  std::unique_ptr<javinolib::Relay> relay;
};

class RadioLibUsualTest : public RadioLibTest {
 protected:
  RadioLibUsualTest() : RadioLibTest(USUAL) {}
};

// A chip as RadioLib's drivers of FSK show it: no scan, no airtime, but the strength of what is heard.
class FskChip : public PhysicalLayer {
 public:
  FskChip() { maxPacketLength = 64; }

  int16_t startReceive() override {
    listens = true;
    return RADIOLIB_ERR_NONE;
  }
  int16_t startTransmit(const uint8_t *data, size_t length, uint8_t) override {
    listens = false;
    sent.assign(data, data + length);
    return RADIOLIB_ERR_NONE;
  }
  int16_t finishTransmit() override { return RADIOLIB_ERR_NONE; }
  size_t getPacketLength(bool) override { return came.size(); }
  int16_t readData(uint8_t *data, size_t length) override {
    std::copy(came.begin(), came.begin() + length, data);
    return RADIOLIB_ERR_NONE;
  }
  float getRSSI() override { return 0; }  // of the last packet
  float getRSSI(bool ofPacket) { return ofPacket ? 0 : dbm; }
  void setPacketReceivedAction(void (*call)()) override { interrupt = call; }
  void setPacketSentAction(void (*call)()) override { interrupt = call; }
  Module *getMod() override { return nullptr; }

  bool listens = false;
  Bytes sent, came;
  float dbm = -100;
  void (*interrupt)() = nullptr;
};

}  // namespace

INSTANTIATE_TEST_SUITE_P(rates, RadioLibTest, testing::Values(FAST, USUAL, SLOW));

TEST_P(RadioLibTest, delivers_a_sealed_unicast_without_a_retry) {
  send("SUPO", "tell;near");
  EXPECT_THAT(received(), ElementsAre("tell;near"));
  EXPECT_THAT(outcomes(), ElementsAre(DELIVERED));
  EXPECT_EQ(2, air.past.size());
  EXPECT_EQ(0, air.collisions);
}

TEST_P(RadioLibTest, delivers_fragments_of_which_two_were_damaged) {
  const std::string content(300, 'x');
  send("SUPO", content);
  while (air.past.size() != 2) pass(1);
  air.lost = 2;
  EXPECT_THAT(received(), ElementsAre(content));
  EXPECT_THAT(outcomes(), ElementsAre(DELIVERED));
  EXPECT_EQ(2, counter(supo, Counter::RADIO_DAMAGED));
  EXPECT_EQ(0, counter(supo, Counter::RADIO_EXPIRED));
}

TEST_P(RadioLibTest, sends_what_was_damaged_again) {
  air.lost = 2;
  send("SUPO", "tell;again");
  EXPECT_THAT(received(), ElementsAre("tell;again"));
  EXPECT_THAT(outcomes(), ElementsAre(DELIVERED));
  EXPECT_EQ(2, counter(supo, Counter::RADIO_DAMAGED));
}

TEST_P(RadioLibTest, delivers_through_a_relay) {
  beginRelay();
  send("SUPO", "tell;far");
  EXPECT_THAT(received(), ElementsAre("tell;far"));
  EXPECT_EQ(0, air.past[0].bytes[0]);
  const auto copy = std::find_if(air.past.begin(), air.past.end(),
                                 [this](const LoRaAir::Packet &packet) { return packet.from == &thirdChip.hardware; });
  EXPECT_EQ(1, copy->bytes[0] % javinolib::HOPS_MODULUS);
  EXPECT_THAT(outcomes(), ElementsAre(DELIVERED));
  send("////", "tell;all");
  EXPECT_THAT(received(), ElementsAre("tell;all"));
}

TEST_P(RadioLibTest, does_not_send_into_anothers_packet) {
  send("////", "tell;one");
  while (air.past.empty()) pass(1);
  supo.use();
  for (const char *content : {"tell;two", "tell;three"}) supo.transmit("////", "SUPO", content);
  pass(20000);
  EXPECT_EQ(3, air.past.size());
  EXPECT_EQ(0, air.collisions);
  EXPECT_EQ(1, counter(supo, Counter::RADIO_RECEIVED));
  EXPECT_EQ(2, counter(roma, Counter::RADIO_RECEIVED));
}

TEST_P(RadioLibTest, hears_a_packet_behind_its_header) {
  send("////", std::string(67, 'x'));
  while (air.past.empty() || air.micros < air.past[0].hasHeader + 2000) pass(1);
  supo.use();
  supo.transmit("////", "SUPO", "tell;two");
  pass(20000);
  EXPECT_EQ(2, air.past.size());
  EXPECT_EQ(0, air.collisions);
}

TEST_P(RadioLibTest, tells_a_packets_time_or_little_more) {
  const AirRate rate =
      AirRate::lora(GetParam().spreading, static_cast<uint32_t>(1000 * GetParam().kilohertz), GetParam().coding);
  for (size_t length = 1; length <= 67; length++) {
    send("////", std::string(length, 'x'));
    EXPECT_THAT(outcomes(), testing::SizeIs(1));
    const LoRaAir::Packet &packet = air.past.back();
    const uint64_t micros = packet.ends - packet.begun;
    const uint64_t most = micros + 3 * GetParam().coding * packet.symbol / 2 + 2000;
    const uint8_t bytes = static_cast<uint8_t>(packet.bytes.size());
    EXPECT_GE(1000u * romaChip.radio.airtimeMillis(static_cast<uint8_t>(bytes - 1)), micros) << length;
    EXPECT_LE(1000u * romaChip.radio.airtimeMillis(static_cast<uint8_t>(bytes - 1)), most) << length;
    EXPECT_GE(1000u * rate.millis(bytes), micros) << length;
    EXPECT_LE(1000u * rate.millis(bytes), most) << length;
  }
}

TEST_P(RadioLibTest, waits_for_no_longer_than_a_millisecond) {
  send("SUPO", "tell;near");
  uint64_t before = romaChip.hardware.waited;
  uint64_t longest = 0;
  for (int millis = 0; millis < 10000; millis++) {
    pass(1);
    longest = std::max(longest, romaChip.hardware.waited - before);
    before = romaChip.hardware.waited;
  }
  EXPECT_GT(romaChip.hardware.scans, 0u);
  EXPECT_LE(longest, 1000u);
}

TEST_F(RadioLibUsualTest, counts_a_packet_as_ended_if_no_interrupt_tells_it) {
  romaChip.hardware.interrupts = false;
  for (const char *content : {"tell;one", "tell;two"}) send("////", content);
  EXPECT_THAT(received(2), ElementsAre("tell;one", "tell;two"));
  EXPECT_EQ(2, counter(roma, Counter::RADIO_SENT));
}

TEST_F(RadioLibUsualTest, listens_again_if_nothing_is_sent_on_a_free_channel) {
  const unsigned before = supoChip.hardware.scans;
  supo.use();
  EXPECT_FALSE(supoChip.radio.send(reinterpret_cast<const uint8_t *>("x"), 1));
  pass(100);
  EXPECT_EQ(1, supoChip.hardware.scans - before);
  send("////", "tell;one");
  EXPECT_THAT(received(), ElementsAre("tell;one"));
}

TEST_F(RadioLibUsualTest, counts_packets_of_others_as_damaged) {
  const uint8_t foreign[100] = {javinolib::PATHS};
  uint32_t count = 0;
  for (size_t length : {1, 30, 79, 100}) {
    thirdChip.driver.startTransmit(foreign, length);
    pass(500);
    EXPECT_EQ(++count, counter(supo, Counter::RADIO_DAMAGED)) << length;
  }
}

TEST_F(RadioLibUsualTest, listens_again_if_a_header_had_no_packet) {
  thirdChip.driver.startTransmit(reinterpret_cast<const uint8_t *>("\0x"), 2);
  pass(25);
  air.breakOff();
  EXPECT_TRUE(supoChip.radio.carrier());
  pass(500);
  EXPECT_FALSE(supoChip.radio.carrier());
  EXPECT_EQ(1, counter(supo, Counter::RADIO_DAMAGED));
}

TEST(RadioLib, refuses_what_is_too_slow) {
  struct {
    Settings settings;
    bool begins;
  } const cases[] = {{SLOW, true},          {{125, 12, 8}, false},  {{62.5, 12, 5}, false},
                     {{62.5, 11, 5}, true}, {{10.4f, 9, 5}, false}, {{500, 12, 8}, true}};
  FakeClock clock;
  for (const auto &row : cases) {
    LoRaAir air;
    Chip<0> chip(air, row.settings);
    EXPECT_EQ(row.begins, chip.radio.begin()) << testing::PrintToString(row.settings);
    EXPECT_GE(chip.radio.slotMillis(), 1);
  }
}

TEST(RadioLib, hears_by_strength_where_a_chip_has_no_scan) {
  FakeClock clock;
  FskChip chip;
  javinolib::NumberedRadioLibRadio<3> radio(chip, AirRate::fsk(4800));
  javinolib::Received with;
  ASSERT_TRUE(radio.begin());
  EXPECT_EQ(60, radio.longestPayload());
  for (float dbm : {-100, -80, -100}) {
    clock.millis++;
    chip.dbm = dbm;
    EXPECT_EQ(nullptr, radio.receive(with));
    radio.carrier();  // one that came before
    EXPECT_EQ(dbm > -90, radio.carrier());
    EXPECT_EQ(dbm < -90, radio.send(reinterpret_cast<const uint8_t *>("ab"), 2)) << dbm;
    if (!radio.sending()) continue;
    EXPECT_EQ((Bytes{0, 'a', 'b'}), chip.sent);
    chip.interrupt();
    EXPECT_EQ(nullptr, radio.receive(with));
    EXPECT_FALSE(radio.sending());
    EXPECT_TRUE(chip.listens);
  }
  chip.came = {2, 'c'};
  chip.interrupt();
  const uint8_t *const payload = radio.receive(with);
  ASSERT_NE(nullptr, payload);
  EXPECT_EQ('c', *payload);
  EXPECT_EQ(1, with.length);
  EXPECT_EQ(2, with.path);
}

TEST(RadioLib, refuses_a_chip_without_a_rate) {
  FakeClock clock;
  FskChip chip;
  EXPECT_FALSE(javinolib::NumberedRadioLibRadio<3>(chip).begin());
}
