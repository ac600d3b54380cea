#include "Registers.h"

PointRegister pointRegister;
uint8_t firstOperand;
uint8_t secondOperand;
std::vector<PointRegister::Point> *PointRegister::list;

PointRegister &PointRegister::operator=(uint8_t number) {
  if (list) list->push_back({number, firstOperand, secondOperand});
  return *this;
}
