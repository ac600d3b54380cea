// A board that speaks the older protocol (SPEC.md, section 8) at 9600 baud, as boards do that were flashed with its
// library: it keeps one message only, which a later one replaces until loop() comes round; it forgets what has not ended
// 300 ms after it began; and it does not answer an action.
//
// It perceives its LED, and how many actions came and which was the last: what got lost shows.

const uint8_t LED_PIN = 13;
// A round of a sketch that has something else to do.
const uint8_t ROUND_MS = 30;
const uint16_t MESSAGE_MS = 300;
const char PREAMBLE[] = "fffe";
const uint8_t HEADER = 6;

char message[256];
bool complete = false;

uint16_t received = 0;
uint16_t expected = 0;
uint32_t began = 0;

uint16_t performed = 0;
char last[32] = "none";

int8_t hexadecimal(char digit) {
  if (digit >= '0' && digit <= '9') return digit - '0';
  if (digit >= 'A' && digit <= 'F') return digit - 'A' + 10;
  if (digit >= 'a' && digit <= 'f') return digit - 'a' + 10;
  return -1;
}

void take(char byte) {
  if (received == 0) began = millis();
  if (received < 4 && byte != PREAMBLE[received]) {
    received = 0;
    return;
  }
  if (received == 4) expected = hexadecimal(byte) << 4;
  if (received == 5) expected |= hexadecimal(byte);
  if (received >= HEADER) message[received - HEADER] = byte;
  ++received;
  complete = received > HEADER && received == HEADER + expected;
  if (complete) {
    message[expected] = 0;
    received = 0;
  }
}

void serialEvent() {
  while (Serial.available()) {
    if (received > 0 && millis() - began > MESSAGE_MS) received = 0;
    take(Serial.read());
  }
}

void answer(const String &percepts) {
  char size[3];
  snprintf(size, sizeof size, "%02X", percepts.length());
  Serial.print(PREAMBLE);
  Serial.print(size);
  Serial.print(percepts);
}

void perform(const char *action) {
  ++performed;
  strncpy(last, action, sizeof last - 1);
  if (strcmp(action, "ledOn") == 0) digitalWrite(LED_PIN, HIGH);
  if (strcmp(action, "ledOff") == 0) digitalWrite(LED_PIN, LOW);
}

void setup() {
  pinMode(LED_PIN, OUTPUT);
  Serial.begin(9600);
}

void loop() {
  delay(ROUND_MS);
  if (!complete) return;
  complete = false;
  if (strcmp(message, "getPercepts") == 0) {
    answer(String("led(") + (digitalRead(LED_PIN) ? "on" : "off") + ");performed(" + performed + ");last(" + last +
           ");");
  } else {
    perform(message);
  }
}
