#include <Arduino.h>

// The chip: start-up, SysTick, UARTs (ARM's CMSDK APB UART).

namespace {

struct Uart {
  uint32_t data, state, control, interrupts, divisor;
};

const uint32_t TX_FULL = 1, RX_FULL = 2;                        // in state
const uint32_t TX_ON = 1, RX_ON = 2, RX_INTERRUPT_ON = 1 << 3;  // in control
const uint32_t RX_INTERRUPT = 2;                                // in interrupts

const uint32_t CLOCK = 25000000;

volatile Uart &uart(uint8_t number) { return *reinterpret_cast<volatile Uart *>(0x40004000 + 0x1000 * number); }

volatile uint32_t &reg(uint32_t address) { return *reinterpret_cast<volatile uint32_t *>(address); }

const uint32_t SYSTICK_CONTROL = 0xE000E010, SYSTICK_RELOAD = 0xE000E014, SYSTICK_VALUE = 0xE000E018;
const uint32_t ENABLED_INTERRUPTS = 0xE000E100;

volatile uint32_t ticks;
HardwareSerial *ports[3];

}  // namespace

extern "C" {

int main();

extern uint32_t stackEnd, dataInFlash, dataBegin, dataEnd, bssBegin, bssEnd;
extern void (*constructors[])(), (*constructorsEnd[])();

// Objects live as long as the program.
int __aeabi_atexit(void *, void (*)(void *), void *) { return 0; }
void *__dso_handle;
void __cxa_pure_virtual() {
  while (true) {
  }
}

void reset() {
  memcpy(&dataBegin, &dataInFlash, reinterpret_cast<char *>(&dataEnd) - reinterpret_cast<char *>(&dataBegin));
  memset(&bssBegin, 0, reinterpret_cast<char *>(&bssEnd) - reinterpret_cast<char *>(&bssBegin));
  reg(SYSTICK_RELOAD) = CLOCK / 1000 - 1;
  reg(SYSTICK_VALUE) = 0;
  reg(SYSTICK_CONTROL) = 7;  // on, with its interrupt, by the CPU's clock
  for (void (**next)() = constructors; next != constructorsEnd; next++) (*next)();
  main();
}

void fault() {
  while (true) {
  }
}

void tick() { ticks = ticks + 1; }

void received0() { ports[0]->onReceived(); }
void received1() { ports[1]->onReceived(); }
void received2() { ports[2]->onReceived(); }

typedef void (*Handler)();
__attribute__((section(".vectors"), used)) const Handler vectors[16 + 5] = {reinterpret_cast<Handler>(&stackEnd),
                                                                            reset,
                                                                            fault,
                                                                            fault,
                                                                            fault,
                                                                            fault,
                                                                            fault,
                                                                            fault,
                                                                            fault,
                                                                            fault,
                                                                            fault,
                                                                            fault,
                                                                            fault,
                                                                            fault,
                                                                            fault,
                                                                            tick,
                                                                            received0,
                                                                            fault,
                                                                            received1,
                                                                            fault,
                                                                            received2};
}

unsigned long millis() { return ticks; }

unsigned long micros() {
  while (true) {
    const uint32_t before = ticks;
    const uint32_t micros = (CLOCK / 1000 - 1 - reg(SYSTICK_VALUE)) / (CLOCK / 1000000);
    if (before == ticks) return before * 1000 + micros;
  }
}

void delayMicroseconds(unsigned int time) {
  for (const unsigned long begin = micros(); micros() - begin < time;) {
  }
}

void yield() { __asm__ volatile("wfi"); }

namespace arduino {

void HardwareSerial::begin(unsigned long baud) {
  ports[number_] = this;
  uart(number_).divisor = CLOCK / baud;
  uart(number_).control = TX_ON | RX_ON | RX_INTERRUPT_ON;
  reg(ENABLED_INTERRUPTS) = 1 << 2 * number_;
}

// A full buffer leaves the byte in the UART, whose other end waits: QEMU knows no bit rate, at which the loop would keep up.
void HardwareSerial::onReceived() {
  uart(number_).interrupts = RX_INTERRUPT;
  if (room() == 0) {
    uart(number_).control = TX_ON | RX_ON;
    return;
  }
  received_[end_ % sizeof received_] = static_cast<uint8_t>(uart(number_).data);
  end_ = end_ + 1;
}

int HardwareSerial::read() {
  if (available() == 0) return -1;
  const uint8_t byte = received_[begin_ % sizeof received_];
  begin_ = begin_ + 1;
  if ((uart(number_).control & RX_INTERRUPT_ON) == 0) {
    uart(number_).control = TX_ON | RX_ON | RX_INTERRUPT_ON;
    if ((uart(number_).state & RX_FULL) != 0) onReceived();
  }
  return byte;
}

#if !defined(CORE_WITHOUT_ROOM) && !defined(CORE_TELLS_NO_ROOM)
int HardwareSerial::availableForWrite() { return (uart(number_).state & TX_FULL) == 0; }
#endif

size_t HardwareSerial::write(uint8_t byte) {
  while ((uart(number_).state & TX_FULL) != 0) {
  }
  uart(number_).data = byte;
  return 1;
}

}  // namespace arduino
