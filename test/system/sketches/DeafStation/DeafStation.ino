// A station that sends without listening: its radio never hears a carrier. Campaigns measure with it what carrier
// sense is worth. Wiring and all else as in the library's example Station.

#include <Javino.h>
#include <radio/AskRadio.h>

class DeafRadio : public javino::AskRadio {
 public:
  bool carrier() const override { return false; }
};

DeafRadio radio;
javino::Javino board(Serial, "deaf station 1.0", radio);

void setup() {
  pinMode(LED_BUILTIN, OUTPUT);
  digitalWrite(LED_BUILTIN, !board.begin(115200));
}

void loop() {
  board.run();
}
