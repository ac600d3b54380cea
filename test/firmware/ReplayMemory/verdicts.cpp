#include <gtest/gtest.h>
#include <secure/ReplayMemory.h>

#include "support/Bytes.h"

using javino::Address;
using javino::ReplayMemory;

namespace {

const Address SUPO(0x4943ce);
const Address SUPP(0x4943cf);

Bytes nonce(uint32_t epoch, uint32_t counter) {
  return {static_cast<uint8_t>(epoch >> 16),   static_cast<uint8_t>(epoch >> 8),   static_cast<uint8_t>(epoch),
          static_cast<uint8_t>(counter >> 16), static_cast<uint8_t>(counter >> 8), static_cast<uint8_t>(counter)};
}

}  // namespace

TEST(ReplayMemory, takes_only_higher_nonces) {
  ReplayMemory memory;
  EXPECT_EQ(ReplayMemory::NEWER, memory.judge(0, SUPO, nonce(0, 0).data())) << "the first one, whatever it is";
  memory.remember(0, SUPO, nonce(5, 7).data());
  const struct {
    uint32_t epoch;
    uint32_t counter;
    ReplayMemory::Verdict verdict;
  } cases[] = {{5, 7, ReplayMemory::REPLAYED},        {5, 6, ReplayMemory::REPLAYED}, {4, 0xFFFFFF, ReplayMemory::REPLAYED},
               {5, 8, ReplayMemory::NEWER},           {6, 0, ReplayMemory::NEWER},    {0x010000, 0, ReplayMemory::NEWER},
               {0, 0x800000, ReplayMemory::REPLAYED}, {5, 0x100, ReplayMemory::NEWER}};
  for (const auto &entry : cases) {
    EXPECT_EQ(entry.verdict, memory.judge(0, SUPO, nonce(entry.epoch, entry.counter).data()))
        << entry.epoch << "/" << entry.counter;
  }
}

TEST(ReplayMemory, keeps_origins_and_keys_apart) {
  ReplayMemory memory;
  memory.remember(0, SUPO, nonce(5, 7).data());
  EXPECT_EQ(ReplayMemory::NEWER, memory.judge(1, SUPO, nonce(1, 1).data()));
  EXPECT_EQ(ReplayMemory::NEWER, memory.judge(0, SUPP, nonce(1, 1).data()));
}

TEST(ReplayMemory, refuses_new_origins_when_full_and_forgets_none) {
  ReplayMemory memory;
  for (uint8_t i = 0; i < javino::config::REPLAY_ENTRIES; i++) memory.remember(0, Address(i), nonce(5, i).data());
  EXPECT_EQ(ReplayMemory::FULL, memory.judge(0, SUPO, nonce(9, 9).data()));
  for (uint8_t i = 0; i < javino::config::REPLAY_ENTRIES; i++) {
    EXPECT_EQ(ReplayMemory::REPLAYED, memory.judge(0, Address(i), nonce(5, i).data()));
    EXPECT_EQ(ReplayMemory::NEWER, memory.judge(0, Address(i), nonce(6, i).data()));
  }
}

TEST(ReplayMemory, forgets_what_came_under_a_replaced_key_only) {
  ReplayMemory memory;
  memory.remember(0, SUPO, nonce(5, 7).data());
  memory.remember(1, SUPO, nonce(5, 7).data());
  memory.forget(0);
  EXPECT_EQ(ReplayMemory::NEWER, memory.judge(0, SUPO, nonce(5, 7).data()));
  EXPECT_EQ(ReplayMemory::REPLAYED, memory.judge(1, SUPO, nonce(5, 7).data()));
}
