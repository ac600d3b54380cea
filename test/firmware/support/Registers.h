#pragma once

#include <stdint.h>

#include <vector>

/// The chip's general purpose registers, in which the firmware tells its trace points (Trace.h): what is written to the first is
/// kept while a test has a list for it.
class PointRegister {
 public:
  struct Point {
    uint8_t number;
    uint8_t first;
    uint8_t second;
  };

  PointRegister &operator=(uint8_t number);

  static std::vector<Point> *list;
};

extern PointRegister pointRegister;
extern uint8_t firstOperand;
extern uint8_t secondOperand;

#define GPIOR0 pointRegister
#define GPIOR1 firstOperand
#define GPIOR2 secondOperand
