#include <delivery/ByteQueue.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <deque>

#include "support/Bytes.h"

using javinolib::ByteQueue;

namespace {

Bytes contentOf(const ByteQueue::Record &record) { return Bytes(record.bytes, record.bytes + record.length); }

}  // namespace

TEST(ByteQueue, keeps_records_of_any_length_in_order_over_many_random_steps) {
  std::array<uint8_t, 640> block;
  ByteQueue queue(block.data(), block.size());
  std::deque<Bytes> expected;
  size_t used = 0;
  RandomBytes random(22);
  for (int step = 0; step < 20000; step++) {
    const Bytes record = random.bytes(random.number(random.number(8) == 0 ? 600 : 60));
    const bool fits = used + 2 + record.size() <= block.size() && expected.size() < ByteQueue::MAX_RECORDS;
    ASSERT_EQ(fits, queue.fits(static_cast<uint16_t>(record.size())));
    if (fits) {
      std::copy(record.begin(), record.end(), queue.append(static_cast<uint16_t>(record.size())));
      expected.push_back(record);
      used += 2 + record.size();
    } else if (!expected.empty()) {
      const uint32_t index = random.number(random.number(2) == 0 ? 1 : static_cast<uint32_t>(expected.size()));
      ByteQueue::Record removed = queue.first();
      for (uint32_t before = index; before != 0; before--) removed = queue.after(removed);
      queue.remove(removed.bytes);
      used -= 2 + expected[index].size();
      expected.erase(expected.begin() + index);
    }
    ASSERT_EQ(expected.size(), queue.count());
    ByteQueue::Record at = queue.first();
    for (const Bytes &wanted : expected) {
      ASSERT_EQ(wanted, contentOf(at));
      at = queue.after(at);
    }
    ASSERT_EQ(nullptr, at.bytes);
  }
}

TEST(ByteQueue, holds_as_many_records_as_can_be_numbered) {
  std::array<uint8_t, 640> block;
  ByteQueue queue(block.data(), block.size());
  while (queue.fits(0)) queue.append(0);
  EXPECT_EQ(128, queue.count());
}
