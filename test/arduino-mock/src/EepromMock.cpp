#include "EepromMock.h"

#include "Current.h"
#include "EEPROM.h"

EEPROMClass EEPROM;

EepromMock::EepromMock() { Current<EepromMock>::enter(this); }
EepromMock::~EepromMock() { Current<EepromMock>::leave(); }

static EepromMock &eeprom() { return Current<EepromMock>::get("EepromMock"); }

uint8_t EEPROMClass::read(int at) { return eeprom().read(at); }
void EEPROMClass::write(int at, uint8_t value) { eeprom().write(at, value); }
