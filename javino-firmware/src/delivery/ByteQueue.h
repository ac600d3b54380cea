#pragma once

#include <stdint.h>

#include "../Config.h"
#include "../support/Inlining.h"
#include "../support/Zeroed.h"

namespace javinolib {

/// Records of any length in the order in which they came, in one block of bytes that its owner lends. Each takes two
/// bytes more than its length.
///
/// Records lie without a gap from the start of the block: what is removed is closed up by moving the rest, 0.4 ms for
/// 640 bytes on an ATmega. So each record is in one fragment, all free room is of use, and a record of any length fits
/// sooner or later.
class ByteQueue {
 public:
  static const uint8_t MAX_RECORDS = 128;

  /// A record in place; it moves when one before it is removed. No bytes: there is none.
  struct Record {
    uint8_t *bytes;
    Length length;
  };

  ByteQueue(uint8_t *block, Length size) : block_(block), size_(size) {}

  uint8_t count() const { return count_; }

  /// Whether a record of this length can be appended.
  JAVINO_NOINLINE bool fits(Length length) const {
    return count_ < MAX_RECORDS && length + HEAD_LENGTH <= size_ - used_;
  }

  /// Appends a record, to be filled by the caller. Only while it fits.
  JAVINO_NOINLINE uint8_t *append(Length length);

  /// The oldest record.
  Record first() const { return recordAt(block_); }

  /// The record that came after this one.
  Record after(Record record) const { return recordAt(record.bytes + record.length); }

  /// Lends the last bytes of the block, until takeBack(); null where records are there, or would be with the head of another.
  uint8_t *lend(Length length);
  void takeBack(Length length) { size_ = static_cast<Length>(size_ + length); }

  /// Removes a record. Those after it move.
  /// @param bytes where it begins
  JAVINO_NOINLINE void remove(uint8_t *bytes);

 private:
  static const uint8_t HEAD_LENGTH = 2;
  static const uint8_t LEAST_LEFT = 24;  // so that what was lent can become a record, a bit further down

  JAVINO_NOINLINE Record recordAt(uint8_t *head) const;

  uint8_t *const block_;
  Length size_;
  Length used_ JAVINO_ZEROED;
  uint8_t count_ JAVINO_ZEROED;
};

}  // namespace javinolib
