#ifndef NewPing_h
#define NewPing_h

// Takes a timer as the library NewPing does (1.9) for its functions with an interrupt: timer 2, on a Leonardo 4.
class NewPing {
 public:
  static void timer_ms(unsigned long millis, void (*function)());
};

#endif
