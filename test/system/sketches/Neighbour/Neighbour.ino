// A sketch with things beside the library: other libraries, texts on the line, delays, an EEPROM, a button.
//
// Actions: print(Millis), a text so often, 0 for never; wait(Millis), in the action; keep(Number), in the EEPROM;
// slowLoop(Millis), slowPercepts(Millis), what each call takes more.

#include <EEPROM.h>
#include <JavinoBDI.h>
#include <SoftwareSerial.h>
#include <Wire.h>

const uint8_t BUTTON_PIN = 2;
const uint8_t LAMP_PIN = 13;  // says that percepts were asked for
const double STEP = 0.25;

SoftwareSerial other(8, 9);
JavinoBoard board(Serial, "neighbour 1.0");
long printMillis, loopMillis, perceptsMillis, kept;
unsigned long printedAt;

bool print(const JavinoArguments &arguments) { return arguments.integer(0, printMillis); }
bool slowLoop(const JavinoArguments &arguments) { return arguments.integer(0, loopMillis); }
bool slowPercepts(const JavinoArguments &arguments) { return arguments.integer(0, perceptsMillis); }

bool wait(const JavinoArguments &arguments) {
  long millis;
  if (!arguments.integer(0, millis)) return false;
  delay(millis);
  return true;
}

bool keep(const JavinoArguments &arguments) {
  if (!arguments.integer(0, kept)) return false;
  EEPROM.put(0, kept);
  return true;
}

void perceive(JavinoPercepts &percepts) {
  digitalWrite(LAMP_PIN, HIGH);
  if (perceptsMillis != 0) delay(perceptsMillis);
  percepts.event(F("pressed"), digitalRead(BUTTON_PIN));
  percepts.add(F("kept"), kept);
  percepts.add(F("precise"), analogRead(A0) * STEP);
  percepts.add(F("steady"), analogRead(A0) * STEP, 2.5);
  percepts.literal("text(" + String(analogRead(A0)) + ")");
}

void setup() {
  pinMode(LAMP_PIN, OUTPUT);
  pinMode(BUTTON_PIN, INPUT);
  Wire.begin();
  other.begin(9600);
  EEPROM.get(0, kept);
  board.onPercepts(perceive);
  board.action(F("print"), print);
  board.action(F("wait"), wait);
  board.action(F("keep"), keep);
  board.action(F("slowLoop"), slowLoop);
  board.action(F("slowPercepts"), slowPercepts);
  board.begin(115200);
}

void loop() {
  board.run();
  if (loopMillis != 0) delay(loopMillis);
  if (printMillis == 0 || millis() - printedAt < static_cast<unsigned long>(printMillis)) return;
  printedAt = millis();
  Serial.println(F("I am a sketch that prints"));
}
