#include "SerialModule.h"

namespace javinolib {

// A byte takes 1042 µs on the UART; to and from a LoRa module, and 3333 µs on the air, 5417.
const SerialModule HC_12 JAVINO_FLASH = {9600, 77, 35, 35, 1042};
const SerialModule E32 JAVINO_FLASH = {9600, 52, 170, 65, 5417};
const SerialModule E22 JAVINO_FLASH = {9600, 77, 170, 65, 5417};

}  // namespace javinolib
