#pragma once

#include <stdexcept>
#include <string>

/// The mock of one kind that is alive.
template <typename Mock>
class Current {
 public:
  static void enter(Mock *mock) {
    if (mock_ != nullptr) throw std::logic_error("There are two mocks of this kind: end the first one's life before");
    mock_ = mock;
  }

  static void leave() { mock_ = nullptr; }

  /// @param name of the mock's class, for the complaint where none is alive
  static Mock &get(const char *name) {
    if (mock_ == nullptr) throw std::logic_error(std::string("The test needs a ") + name + ": declare one");
    return *mock_;
  }

 private:
  static Mock *mock_;
};

template <typename Mock>
Mock *Current<Mock>::mock_ = nullptr;
