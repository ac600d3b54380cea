// SPDX-License-Identifier: GPL-3.0-or-later
// ELF and Intel HEX files, also cut off or damaged: loaded or refused, under the sanitizers.
#include "support.h"

#include <elf.h>

#include <algorithm>
#include <cctype>
#include <cstring>
#include <numeric>
#include <random>

extern "C" {
#include <simavr/sim_avr.h>
}

namespace {

class Firmware : public testing::Test {
 protected:
  Firmware() : whole(read_text(PROGRAMS_DIR "/blink.elf")), avr(avr_make_mcu_by_name("atmega2560")) { avr_init(avr); }
  ~Firmware() { avr_terminate(avr); }

  bool loads(const std::string &elf) {
    error[0] = 0;
    bool loaded = firmware_load(avr, &MEGA, scratch.write("p.elf", elf).c_str(), error, sizeof error) == 0;
    EXPECT_EQ(loaded, error[0] == 0);
    EXPECT_EQ(std::string(error).find('\n'), std::string::npos);
    return loaded;
  }

  Elf32_Ehdr header() const {
    Elf32_Ehdr header;
    std::memcpy(&header, whole.data(), sizeof header);
    return header;
  }

  // The file with another value in a field of its header or a segment's.
  template <typename T>
  std::string with(size_t at, T value) const {
    std::string changed = whole;
    std::memcpy(&changed[at], &value, sizeof value);
    return changed;
  }

  // What avr-objcopy makes of the program that is loaded.
  std::string hex() const {
    std::string text;
    char digits[3];
    for (uint32_t at = 0; at < avr->codeend; at += 16) {
      std::string line;
      uint32_t length = std::min<uint32_t>(16, avr->codeend - at);
      for (uint32_t byte : {length, at >> 8 & 0xFF, at & 0xFF, 0u}) line += static_cast<char>(byte);
      line.append(reinterpret_cast<const char *>(avr->flash) + at, length);
      line += static_cast<char>(-std::accumulate(line.begin(), line.end(), 0));
      text += ':';
      for (char byte : line) {
        snprintf(digits, sizeof digits, "%02X", static_cast<uint8_t>(byte));
        text += digits;
      }
      text += "\r\n";
    }
    return text + ":00000001FF\r\n";
  }

  Scratch scratch;
  std::string whole;
  avr_t *avr;
  char error[512];
};

}  // namespace

TEST_F(Firmware, that_is_whole_is_loaded) {
  EXPECT_TRUE(loads(whole)) << error;
  EXPECT_EQ(avr->flash[0], 0x0C);  // jmp
  EXPECT_GT(avr->codeend, 100u);
  EXPECT_LT(avr->codeend, 2000u);
}

TEST_F(Firmware, that_points_beyond_the_file_or_the_flash_is_refused_in_one_line) {
  const std::string DAMAGED =
      scratch.path("p.elf") + " is damaged, or holds no program that fits the ATmega2560's flash";
  size_t segment = header().e_phoff;
  const std::string CASES[] = {
      with(offsetof(Elf32_Ehdr, e_phoff), UINT32_MAX - 8),
      with(offsetof(Elf32_Ehdr, e_phnum), UINT16_MAX),
      with<uint16_t>(offsetof(Elf32_Ehdr, e_phnum), 0),
      with<uint16_t>(offsetof(Elf32_Ehdr, e_phentsize), 8),
      with(segment + offsetof(Elf32_Phdr, p_offset), UINT32_MAX - 4),
      with(segment + offsetof(Elf32_Phdr, p_filesz), UINT32_MAX),
      with<uint32_t>(segment + offsetof(Elf32_Phdr, p_paddr), 0x3FFFF),
      with<uint32_t>(segment + offsetof(Elf32_Phdr, p_paddr), 0x7FFFFF),
      whole.substr(0, sizeof(Elf32_Ehdr)),
  };
  for (const std::string &each : CASES) {
    EXPECT_FALSE(loads(each));
    EXPECT_EQ(error, DAMAGED);
  }
}

TEST_F(Firmware, that_is_damaged_anywhere_is_loaded_or_refused) {
  std::mt19937 random(1);
  auto below = [&](size_t limit) { return static_cast<size_t>(random() % limit); };
  int loaded = 0;
  for (int i = 0; i < 4000; i++) {
    std::string damaged = whole;
    // Mostly in the headers, where damage does most.
    size_t part = i % 4 == 0 ? damaged.size() : header().e_phoff + header().e_phnum * sizeof(Elf32_Phdr);
    for (size_t left = 1 + below(4); left > 0; left--)
      damaged[below(part)] = static_cast<char>(i % 3 == 0 ? random() : i % 3 == 1 ? 0xFF : 0x80);
    if (i % 5 == 0) damaged.resize(below(damaged.size() + 1));
    loaded += loads(damaged);
  }
  EXPECT_GT(loaded, 100);
  EXPECT_LT(loaded, 3900);
}

TEST_F(Firmware, that_is_cut_off_at_each_byte_of_its_headers_is_refused) {
  size_t end = header().e_phoff + header().e_phnum * sizeof(Elf32_Phdr);
  for (size_t length = 0; length < end; length++) EXPECT_FALSE(loads(whole.substr(0, length))) << length;
}

TEST_F(Firmware, as_intel_hex_is_the_same) {
  ASSERT_TRUE(loads(whole));
  std::string text = hex();
  uint32_t end = avr->codeend;
  std::vector<uint8_t> flash(avr->flash, avr->flash + end);
  std::fill_n(avr->flash, end, 0);
  EXPECT_TRUE(loads(text)) << error;
  EXPECT_EQ(avr->codeend, end);
  EXPECT_EQ(std::vector<uint8_t>(avr->flash, avr->flash + end), flash);
}

TEST_F(Firmware, as_intel_hex_that_is_none_or_does_not_fit_is_refused_in_one_line) {
  ASSERT_TRUE(loads(whole));
  std::string text = hex();
  for (const std::string &each :
       std::vector<std::string>{":", ":00000001FF\n", text.substr(text.find('\n') + 1), ":020000040004F6\n" + text,
                                ":020000023000CC\n:10FFF8000000000000000000000000000000000000F9\n"}) {
    EXPECT_FALSE(loads(each)) << each;
    EXPECT_NE(std::string(error).find(" is damaged, or holds no program that fits the ATmega2560's flash"),
              std::string::npos)
        << error;
  }
}

TEST_F(Firmware, as_intel_hex_of_which_any_byte_is_changed_or_missing_is_refused) {
  ASSERT_TRUE(loads(whole));
  std::string text = hex();
  std::mt19937 random(2);
  for (size_t at = 0; at + 2 < text.size(); at++) {
    if (text[at] == '\r' || text[at] == '\n') continue;
    std::string changed = text;
    changed[at] = static_cast<char>(at % 2 == 0 ? changed[at] ^ 1 << random() % 8 : random());
    // A letter's other case is the same digit.
    EXPECT_EQ(loads(changed), std::toupper(changed[at]) == text[at]) << at << changed[at];
    EXPECT_FALSE(loads(text.substr(0, at + (at == 0)))) << at;
  }
}
