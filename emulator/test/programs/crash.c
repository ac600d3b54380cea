// SPDX-License-Identifier: GPL-3.0-or-later
// Jumps to where there is no program, and so runs out of the flash.
int main(void) {
  for (volatile unsigned i = 0; i < 1000; i++) {
  }
  __asm__ volatile("jmp 0x3FF00");
  for (;;) {
  }
}
