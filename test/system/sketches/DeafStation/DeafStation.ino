// A station that does not listen before it talks. Campaigns measure with it what carrier sense is worth. Its radio
// hears a carrier only for a third of a second after it has sent: it still waits for an acknowledgement that is on its
// way, or it would talk over the answer to itself. Wiring and all else as in the library's example Station.

#include <JavinoBDI.h>
#include <radio/AskRadio.h>

class DeafRadio : public JavinoAskRadio {
 public:
  bool send(const uint8_t *payload, uint8_t length) override {
    const bool begun = AskRadio::send(payload, length);
    // 84 + 12 bits a byte, of half a millisecond each (SPEC 6).
    if (begun) hearsUntil_ = millis() + (84 + 12 * length) / 2 + 350;
    return begun;
  }

  bool carrier() const override { return static_cast<int32_t>(millis() - hearsUntil_) < 0 && AskRadio::carrier(); }

 private:
  uint32_t hearsUntil_ = 0;
};

DeafRadio radio;
JavinoRadioBoard board(Serial, "deaf station 1.0", radio);

void setup() {
  pinMode(LED_BUILTIN, OUTPUT);
  digitalWrite(LED_BUILTIN, !board.begin(115200));
}

void loop() { board.run(); }
