#ifndef Servo_h
#define Servo_h

#include <stdint.h>

// In the place of Arduino's library, which Debian does not have: one servo on an AVR, by timer 1.
class Servo {
 public:
  // Makes the pin an output with a pulse of 1.5 ms each 20 ms.
  uint8_t attach(int pin);

  // Turns to an angle, 0…180: a pulse of 544…2400 µs.
  void write(int degrees);
};

#endif
