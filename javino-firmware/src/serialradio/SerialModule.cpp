#include "SerialModule.h"

// A byte takes 1042 µs on the UART; to and from a LoRa module, and 3333 µs on the air, 5417.
const javinolib::SerialModule JAVINO_HC_12 JAVINO_FLASH = {9600, 77, 35, 35, 1042};
const javinolib::SerialModule JAVINO_E32 JAVINO_FLASH = {9600, 52, 170, 65, 5417};
const javinolib::SerialModule JAVINO_E22 JAVINO_FLASH = {9600, 77, 170, 65, 5417};
