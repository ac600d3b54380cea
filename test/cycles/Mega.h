// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "program/Mailbox.h"

/// An emulated ATmega2560 that runs the test program.
class Mega {
 public:
  /// Throws where the program cannot be read or does not start.
  explicit Mega(const std::string &program);
  ~Mega();

  /// Has an operation done, with the mailbox as input and output.
  /// @return the CPU cycles that it took, without those of measuring.
  uint64_t perform(Mailbox::Operation operation, Mailbox &mailbox);

 private:
  struct Simulation;

  std::unique_ptr<Simulation> simulation_;
  uint64_t overhead_ = 0;
};
