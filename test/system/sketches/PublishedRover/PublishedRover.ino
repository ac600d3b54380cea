// A rover: two motors, light, distance by ultrasound, battery, and the messages of a sketch that compares texts.

#include <Javino.h>

Javino javino;
String motor = "stopped";

int distance() {
  digitalWrite(5, HIGH);
  delayMicroseconds(10);
  digitalWrite(5, LOW);
  return pulseIn(4, HIGH, 30000) / 58;
}

String status() {
  return "motor(" + motor + ");distance(" + String(distance()) + ");light(" + String(analogRead(A0)) + ");battery(" +
         String(analogRead(A1) / 1024.0) + ");";
}

void drive(const String &how, bool left, bool right) {
  motor = how;
  digitalWrite(7, left);
  digitalWrite(8, right);
}

void setup() {
  javino.start(9600);
  pinMode(5, OUTPUT);
  pinMode(7, OUTPUT);
  pinMode(8, OUTPUT);
}

void loop() {
  if (!javino.availableMsg()) return;
  String message = javino.getMsg();
  if (message == "getPercepts") {
    javino.sendMsg(status());
  } else if (message == "goAhead") {
    drive("ahead", HIGH, HIGH);
  } else if (message == "goLeft") {
    drive("left", LOW, HIGH);
  } else if (message == "goRight") {
    drive("right", HIGH, LOW);
  } else if (message == "stop") {
    drive("stopped", LOW, LOW);
  }
}

void serialEvent() { javino.readSerial(); }
