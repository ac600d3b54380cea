// What a radio over another library's driver tells of its channel, and which channels are too slow.
#include <gtest/gtest.h>
#include <radio/DriverRadio.h>

using javinolib::AirRate;

namespace {

class Measured : public javinolib::DriverRadio {
 public:
  Measured(const AirRate &rate, uint8_t longestPayload, bool hears)
      : DriverRadio(rate, 4), fits(measure(longestPayload, hears)) {}

  bool begin() override { return fits; }
  bool send(const uint8_t *, uint8_t) override { return false; }
  bool carrier() const override { return false; }
  uint8_t *receive(javinolib::Received &) override { return nullptr; }

  const bool fits;
};

}  // namespace

TEST(DriverRadio, fits_channels_from_300_bits_a_second) {
  const struct {
    AirRate rate;
    uint8_t longest;
    bool hears, fits;
    uint8_t slot;  // 2 ms, and a fifth of 12 bytes, or of 42
  } cases[] = {
      {AirRate::fsk(300), 60, true, true, 66},
      {AirRate::fsk(300), 60, false, true, 226},
      {AirRate::fsk(260), 60, true, true, 76},
      {AirRate::fsk(260), 60, false, false, 255},  // a carrier is heard too late
      {AirRate::fsk(150), 60, true, false, 255},   // the longest packet takes 4 s
      {AirRate::fsk(50000), 60, true, true, 2},
      {AirRate::fsk(50000), 60, false, true, 3},
      {AirRate::fsk(50000), 26, true, true, 2},
      {AirRate::fsk(50000), 25, true, false, 255},
      {AirRate::lora(12, 125000, 5), 77, true, true, 164},
      {AirRate::lora(12, 125000, 8), 77, true, false, 255},
      {AirRate::lora(12, 62500, 5), 77, true, false, 255},
  };
  for (const auto &row : cases) {
    const Measured radio(row.rate, row.longest, row.hears);
    SCOPED_TRACE(testing::Message() << row.rate.overheadMicros() << " us, " << int{row.longest} << " bytes");
    EXPECT_EQ(row.fits, radio.fits);
    EXPECT_EQ(row.slot, radio.slotMillis());
    EXPECT_EQ(row.fits ? row.longest : javinolib::MIN_RADIO_PAYLOAD, radio.longestPayload());
  }
}

TEST(DriverRadio, carries_no_more_than_the_boards_buffers) {
  EXPECT_EQ(javinolib::MAX_RADIO_PAYLOAD, Measured(AirRate::fsk(50000), 251, true).longestPayload());
}

// 4 bytes of header and 12 around, 8 bits each at 1 bit a millisecond; always rounded up.
TEST(AirRate, counts_bytes_around_a_payload_and_saturates) {
  EXPECT_EQ((4 + 12 + 30) * 8 + 1, Measured(AirRate::fsk(1000), 60, true).airtimeMillis(30));
  EXPECT_EQ(UINT16_MAX, AirRate(UINT32_MAX / 2, 0).millis(1));
}
