// SPDX-License-Identifier: GPL-3.0-or-later
// ELF files that are cut off or damaged: loaded or refused, under the sanitizers.
#include "support.h"

#include <elf.h>

#include <cstring>
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
