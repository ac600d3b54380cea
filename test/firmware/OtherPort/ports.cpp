#include <Arduino.h>
#include <arduino/OtherPort.h>
#include <gtest/gtest.h>

#include <string>

namespace {

// As the ports of some cores, whose Stream has no availableForWrite().
class Port : public Stream {
 public:
  void begin(unsigned long baud) { rate = baud; }
  int available() override { return static_cast<int>(in.size()); }
  size_t write(uint8_t byte) override {
    out += static_cast<char>(byte);
    return 1;
  }
  int read() override {
    const char byte = in[0];
    in.erase(0, 1);
    return byte;
  }

  unsigned long rate = 0;
  std::string in, out;

 private:
  int availableForWrite() override { throw "it has none"; }
};

class TellingPort : public Port {
 public:
  int availableForWrite() override { return room; }

  int room = 0;
};

}  // namespace

TEST(OtherPort, is_opened_read_and_written_by_its_own_functions) {
  Port port;
  javinolib::SerialPort line = javinolib::hostPort(port);
  line.begin(9600);
  EXPECT_EQ(9600u, port.rate);
  EXPECT_FALSE(line.canRead());
  port.in = "x";
  ASSERT_TRUE(line.canRead());
  EXPECT_EQ('x', line.read());
  ASSERT_TRUE(line.canWrite());
  line.write('y');
  EXPECT_EQ("y", port.out);
}

TEST(OtherPort, takes_bytes_where_it_never_tells_its_room_and_waits_where_it_has) {
  TellingPort port;
  javinolib::SerialPort line = javinolib::hostPort(port);
  EXPECT_TRUE(line.canWrite());
  port.room = 1;
  EXPECT_TRUE(line.canWrite());
  port.room = 0;
  EXPECT_FALSE(line.canWrite());
}
