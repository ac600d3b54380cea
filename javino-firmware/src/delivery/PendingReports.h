#pragma once

#include <stdint.h>
#include <string.h>

#include "../support/Zeroed.h"

namespace javinolib {

/// News for the host in the order in which they came, until it has had them (SPEC 4.3).
template <typename News, uint8_t capacity>
class PendingReports {
 public:
  static const uint8_t CAPACITY = capacity;

  /// How much there is that the host is not known to have had.
  uint8_t count() const { return count_; }

  /// Whether any is to be told.
  bool arePending() const { return told_ != count_; }

  /// The next one to be told. Only while there is one.
  const News &next() const { return news_[told_]; }

  /// The same, which is told now.
  const News &tell() { return news_[told_++]; }

  /// The host has had all that was told.
  void forgetTold() {
    count_ = static_cast<uint8_t>(count_ - told_);
    memmove(news_, news_ + told_, count_ * sizeof(News));
    told_ = 0;
  }

  /// The host may not have had it.
  void keepTold() { told_ = 0; }

 protected:
  /// The place of one more. Only while there are fewer than fit.
  News &append() { return news_[count_++]; }

  const News &at(uint8_t index) const { return news_[index]; }

 private:
  uint8_t count_ JAVINO_ZEROED;
  uint8_t told_ JAVINO_ZEROED;
  News news_[capacity];
};

}  // namespace javinolib
