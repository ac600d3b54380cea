// The places that the assembly relies on: LPM reads the lowest 64 KiB, and a byte is an address in an aligned table.
#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

// Lines of avr-nm: address, type, name.
unsigned long addressOf(const std::string &name) {
  std::ifstream symbols(SYMBOLS);
  std::string address, type, symbol;
  while (symbols >> address >> type >> symbol) {
    if (symbol == name) return std::stoul(address, nullptr, 16);
  }
  throw std::runtime_error(std::string(SYMBOLS) + " has no symbol " + name);
}

}  // namespace

TEST(Tables, lie_aligned_in_the_lowest_64_KiB) {
#ifdef JAVINO_SMALL
  const std::vector<const char *> tables = {"s_box"};
#else
  const std::vector<const char *> tables = {"s_box", "doubled"};
#endif
  for (const char *table : tables) {
    const unsigned long address = addressOf(table);
    EXPECT_EQ(0u, address % 256) << table;
    EXPECT_LE(address + 256, 0x10000u) << table;
  }
}
