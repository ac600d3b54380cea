#include "Actions.h"

namespace javinolib {

namespace {

bool equal(const FlashText *known, const char *name, Length length) {
  for (uint16_t i = 0; i < length; i++) {
    if (flashChar(known, i) != name[i]) return false;  // its closing zero is no character of a name
  }
  return flashChar(known, length) == 0;
}

bool equal(const FlashText *known, const FlashText *name) {
  for (uint16_t i = 0;; i++) {
    const char next = flashChar(name, i);
    if (flashChar(known, i) != next) return false;
    if (next == 0) return true;
  }
}

}  // namespace

bool Actions::add(const FlashText *name, Action action) {
  if (name == nullptr || action == nullptr || flashChar(name, 0) == 0 || count_ == config::ACTIONS) return false;
  for (uint8_t i = 0; i < count_; i++) {
    if (equal(entries_[i].name, name)) return false;
  }
  entries_[count_].name = name;
  entries_[count_].action = action;
  if (count_++ == 0) performer_ = performNamed;
  return true;
}

Status Actions::performNamed(Part<Actions> actions, const uint8_t *action, Length length, Reply &) {
  Arguments arguments;
  if (!arguments.parse(action, length)) return Status::BAD_ARGUMENT;
  const Entry *const found = actions->find(arguments);
  if (found == nullptr) return Status::UNKNOWN_ACTION;
  return found->action(arguments) ? Status::OK : Status::ACTION_FAILED;
}

Status Actions::list(const uint8_t *offset, Length length, Reply &reply) const {
  if (length != 2) return Status::BAD_ARGUMENT;
  uint16_t skipped = static_cast<uint16_t>(offset[0] << 8 | offset[1]);
  reply.add(count_);
  for (uint8_t i = 0; i < count_; i++) {
    const uint8_t *at = reinterpret_cast<const uint8_t *>(entries_[i].name);
    uint8_t next;
    do {
      next = flashByte(at++);
      if (skipped != 0) {
        skipped--;
      } else {
        reply.add(next);  // once it is full it takes no more
      }
    } while (next != 0);
  }
  return Status::OK;
}

const Actions::Entry *Actions::find(const Arguments &wanted) const {
  for (uint8_t i = 0; i < count_; i++) {
    if (equal(entries_[i].name, wanted.name(), wanted.nameLength())) return entries_ + i;
  }
  return nullptr;
}

}  // namespace javinolib
