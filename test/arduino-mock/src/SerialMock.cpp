#include "SerialMock.h"

#include "Arduino.h"
#include "Current.h"

HardwareSerial Serial;

SerialMock::SerialMock() { Current<SerialMock>::enter(this); }
SerialMock::~SerialMock() { Current<SerialMock>::leave(); }

static SerialMock &serial() { return Current<SerialMock>::get("SerialMock"); }

void HardwareSerial::begin(unsigned long baud) { serial().begin(baud); }
int HardwareSerial::available() { return serial().available(); }
int HardwareSerial::read() { return serial().read(); }
int HardwareSerial::availableForWrite() { return serial().availableForWrite(); }
size_t HardwareSerial::write(uint8_t byte) { return serial().write(byte); }
