// A stepper that speeds up and slows down, as people build it: for its size on an Uno. The code in place of a library is as
// large as that.
//
// Wiring: the four coils by a driver to pins 4 to 7; receiver to pin 11, transmitter to pin 12.
//
// Actions:  moveTo(Steps), move(Steps), speed(StepsASecond), halt
// Percepts: position(Steps), left(Steps), speed(StepsASecond), idle

#include <JavinoBDI.h>

JavinoAskRadio radio;
JavinoUnicastBoard board(Serial, "turntable 1.0", radio);

// The time between two steps follows from the one before (David Austin, 2005).
class Stepper {
 public:
  void begin() {
    for (uint8_t pin = FIRST_PIN; pin < FIRST_PIN + 4; pin++) pinMode(pin, OUTPUT);
    setMaxSpeed(500);
    setAcceleration(200);
  }

  void setMaxSpeed(float speed) {
    maxSpeed_ = speed;
    shortest_ = 1e6 / speed;
    plan();
  }

  void setAcceleration(float acceleration) {
    acceleration_ = acceleration;
    first_ = 0.676 * sqrt(2 / acceleration) * 1e6;
    plan();
  }

  void moveTo(long target) {
    target_ = target;
    plan();
  }

  void move(long steps) { moveTo(position_ + steps); }
  void halt() { move(forward_ ? stepsToStop() : -stepsToStop()); }
  long position() const { return position_; }
  long left() const { return target_ - position_; }
  float speed() const { return interval_ == 0 ? 0 : (forward_ ? 1e6 : -1e6) / interval_; }

  void run() {
    if (interval_ == 0 || micros() - steppedAt_ < interval_) return;
    steppedAt_ = micros();
    position_ += forward_ ? 1 : -1;
    static const uint8_t COILS[] = {0x5, 0x6, 0xA, 0x9};
    const uint8_t coils = COILS[position_ & 3];
    for (uint8_t i = 0; i < 4; i++) digitalWrite(FIRST_PIN + i, coils >> i & 1);
    plan();
  }

 private:
  static const uint8_t FIRST_PIN = 4;

  long stepsToStop() const { return speed() * speed() / (2 * acceleration_); }

  void plan() {
    const long left = this->left();
    if (left == 0 && stepsToStop() <= 1) {
      interval_ = 0;
      step_ = 0;
      return;
    }
    const bool towards = forward_ == (left > 0);
    if (step_ > 0 && (!towards || stepsToStop() >= abs(left))) {
      step_ = -stepsToStop();
    } else if (step_ < 0 && towards && stepsToStop() < abs(left)) {
      step_ = -step_;
    }
    if (step_ == 0) {
      time_ = first_;
      forward_ = left > 0;
    } else {
      time_ = time_ - 2 * time_ / (4 * step_ + 1);
      time_ = max(time_, shortest_);
    }
    step_++;
    interval_ = time_;
  }

  float maxSpeed_, acceleration_, first_, shortest_, time_;
  long position_, target_, step_;
  unsigned long interval_, steppedAt_;
  bool forward_;
};

Stepper stepper;

bool moveTo(const JavinoArguments &arguments) {
  long steps;
  if (!arguments.integer(0, steps)) return false;
  stepper.moveTo(steps);
  return true;
}

bool move(const JavinoArguments &arguments) {
  long steps;
  if (!arguments.integer(0, steps)) return false;
  stepper.move(steps);
  return true;
}

bool setSpeed(const JavinoArguments &arguments) {
  long speed;
  if (!arguments.integer(0, speed) || speed <= 0) return false;
  stepper.setMaxSpeed(speed);
  return true;
}

bool halt(const JavinoArguments &) {
  stepper.halt();
  return true;
}

void perceive(JavinoPercepts &percepts) {
  percepts.add(F("position"), stepper.position());
  percepts.add(F("left"), stepper.left());
  percepts.add(F("speed"), stepper.speed(), 1.0);
  if (stepper.left() == 0) percepts.add(F("idle"));
}

void setup() {
  stepper.begin();
  board.onPercepts(perceive);
  board.action(F("moveTo"), moveTo);
  board.action(F("move"), move);
  board.action(F("speed"), setSpeed);
  board.action(F("halt"), halt);
  board.begin(115200);
}

void loop() {
  board.serve();
  stepper.run();
}
