#include <framing/Address.h>
#include <gtest/gtest.h>

#include "support/Digits.h"
#include "support/Vectors.h"

using javinolib::Address;

namespace {

std::string classNameOf(Address::Kind addressClass) {
  switch (addressClass) {
    case Address::DEVICE: return "device";
    case Address::SERIAL_LINE: return "serial";
    case Address::BROADCAST: return "broadcast";
    case Address::MULTICAST: return "multicast";
    case Address::FRAGMENT: return "fragment";
    case Address::ACKNOWLEDGEMENT: return "acknowledgement";
    default: return "reserved";
  }
}

uint16_t half(const std::string &digits) {
  return static_cast<uint16_t>(javinolib::base64Value(static_cast<uint8_t>(digits.at(0))) * 64 +
                               javinolib::base64Value(static_cast<uint8_t>(digits.at(1))));
}

}  // namespace

TEST(Address, reads_all_valid_vectors) {
  for (const Vector &vector : vectors("addresses.json", "valid")) {
    SCOPED_TRACE(vector.toString());
    Address address;
    ASSERT_TRUE(Address::parse(bytesOf(vector.text("text")).data(), address));
    EXPECT_EQ(std::stoul(vector.text("value"), nullptr, 16), address.value());
    EXPECT_EQ(vector.text("class"), classNameOf(address.kind()));
    EXPECT_EQ(half(vector.text("group")), address.group());
    EXPECT_EQ(half(vector.text("member")), address.member());
  }
}

TEST(Address, writes_what_it_read) {
  for (const Vector &vector : vectors("addresses.json", "valid")) {
    Bytes text(4);
    Address(static_cast<uint32_t>(std::stoul(vector.text("value"), nullptr, 16))).write(text.data());
    EXPECT_EQ(vector.text("text"), textOf(text));
  }
}

TEST(Address, stores_its_value_in_three_bytes_the_highest_first) {
  for (const Vector &vector : vectors("addresses.json", "valid")) {
    SCOPED_TRACE(vector.toString());
    const uint32_t value = static_cast<uint32_t>(std::stoul(vector.text("value"), nullptr, 16));
    Bytes bytes(3);
    Address(value).store(bytes.data());
    EXPECT_EQ(value, static_cast<uint32_t>(bytes[0] << 16 | bytes[1] << 8 | bytes[2]));
    EXPECT_EQ(Address(value), Address::stored(bytes.data()));
  }
}

// The length is the caller's to see to: an address is always read from four bytes.
TEST(Address, refuses_invalid_vectors_of_four_bytes) {
  int refused = 0;
  for (const Vector &vector : vectors("addresses.json", "invalid")) {
    const Bytes text = bytesOf(vector.text("text"));
    if (text.size() != Address::TEXT_LENGTH) continue;
    SCOPED_TRACE(vector.toString());
    Address address(42);
    EXPECT_FALSE(Address::parse(text.data(), address));
    EXPECT_EQ(Address(42), address) << "a refused text leaves the address alone";
    refused++;
  }
  EXPECT_GT(refused, 0);
}

TEST(Address, every_byte_outside_the_alphabet_is_no_digit) {
  for (int byte = 0; byte < 256; byte++) {
    const size_t value = digits().find(static_cast<char>(byte));
    const uint8_t expected = value == std::string::npos ? javinolib::NOT_A_DIGIT : static_cast<uint8_t>(value);
    EXPECT_EQ(expected, javinolib::base64Value(static_cast<uint8_t>(byte))) << byte;
    if (value == std::string::npos) continue;
    EXPECT_EQ(byte, javinolib::base64Digit(expected));
  }
}

TEST(Address, of_the_serial_line_is_no_device) {
  EXPECT_TRUE(Address::serialLine().isSerial());
  EXPECT_FALSE(Address::serialLine().isDevice());
}
