// A lamp by the published library's interface, with messages that the sketch reads itself.

#include <Javino.h>

Javino javino;
String said;

String percepts() {
  String all = "device(lamp);level(" + String(digitalRead(13)) + ");";
  if (said.length() != 0) all += "said(" + said + ");";
  return all;
}

void setup() {
  pinMode(13, OUTPUT);
  javino.start(9600);
}

void loop() {
  if (!javino.availableMsg()) return;
  if (javino.requestPercepts()) {
    javino.sendMsg(percepts());
  } else if (javino.requestAction("lampOn")) {
    digitalWrite(13, HIGH);
  } else if (javino.getMsg() == "lampOff") {
    digitalWrite(13, LOW);
  } else {
    said = javino.getMsg();
  }
}

void serialEvent() { javino.readSerial(); }
