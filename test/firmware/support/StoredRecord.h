#pragma once

#include <storage/EepromRecord.h>

#include "Bytes.h"

/// A record in the simulated EEPROM.
class StoredRecord {
 public:
  StoredRecord(uint16_t at, uint8_t length) : record_(at, length), length_(length) {}

  /// The record that is there, or nothing.
  Bytes begin() const {
    Bytes data = room();
    return found(record_.begin(data.data(), 0), data);
  }

  Bytes read() const {
    Bytes data = room();
    return found(record_.read(data.data()), data);
  }

  bool write(const Bytes &content) const {
    Bytes data = content;
    data.resize(room().size());
    return record_.write(data.data());
  }

  bool erase(uint8_t secrets) const { return record_.erase(secrets); }

 private:
  Bytes room() const { return Bytes(length_ + javinolib::EepromRecord::CHECK_LENGTH); }
  Bytes found(bool whole, const Bytes &data) const {
    return whole ? Bytes(data.begin(), data.begin() + length_) : Bytes();
  }

  const javinolib::EepromRecord record_;
  const uint8_t length_;
};
