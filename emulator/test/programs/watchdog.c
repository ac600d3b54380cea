// SPDX-License-Identifier: GPL-3.0-or-later
// Lets the watchdog bite after 15 ms.
#include <avr/wdt.h>

int main(void) {
  wdt_enable(WDTO_15MS);
  for (;;) {
  }
}
