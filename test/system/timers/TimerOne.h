#ifndef TimerOne_h_
#define TimerOne_h_

// Takes timer 1 as the library TimerOne does (1.2): its overflow interrupt and a mode of PWM of its own.
class TimerOne {
 public:
  void initialize(unsigned long micros);
  void attachInterrupt(void (*function)());
};

extern TimerOne Timer1;

#endif
