// SPDX-License-Identifier: GPL-3.0-or-later
// Runs into an opcode that does not exist.
int main(void)
{
    for (volatile unsigned i = 0; i < 1000; i++)
        ;
    __asm__ volatile(".word 0xFFFF");
    for (;;)
        ;
}
