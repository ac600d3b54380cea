#ifndef Servo_h
#define Servo_h

#include <stdint.h>

// Takes its timers as Arduino's library Servo does (1.2.2): unit A of a Mega's timers 5, 1, 3, 4 in this order, of other boards'
// timer 1; for 12 servos one more timer, when the first of them is attached. All handlers are there from the first servo on.
class Servo {
 public:
  Servo();
  void attach(int pin);

 private:
  uint8_t index_;
};

#endif
