#pragma once

#include <storage/Retained.h>

#include "Bytes.h"

/// The RAM that a reset leaves alone, of a chip that is powered up: garbage at first. The one that was made or told to
/// be used last is the chip's.
class SimulatedRam {
 public:
  SimulatedRam();
  ~SimulatedRam();
  SimulatedRam(const SimulatedRam &) = delete;
  SimulatedRam &operator=(const SimulatedRam &) = delete;

  /// Makes this the chip's: for tests with several boards. A ReplayMemory takes hold of it when it is made.
  void use();

  /// The power was gone: garbage again.
  void losePower();

  Bytes content() const;
  void restore(const Bytes &content);

  javinolib::TakenNonces takenNonces;
  javinolib::retained::Airtime airtime;
  bool isClear = true;  ///< of the stack

 private:
  SimulatedRam *const before_;
  RandomBytes random_;
};
