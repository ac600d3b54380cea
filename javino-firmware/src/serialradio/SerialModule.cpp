#include "SerialModule.h"

#define JAVINO_SERIAL_MODULE(name, text, baud, longestPayload, slotMillis, airtimeMillis, airtimeMicros, ...) \
  const javinolib::SerialModule name JAVINO_FLASH = {baud, longestPayload, slotMillis, airtimeMillis, airtimeMicros};
#include "SerialModules.def"
#undef JAVINO_SERIAL_MODULE
