#pragma once

namespace javinolib {

/// Sleep and interrupts of the CPU; bound when linking, to Cpu.cpp on a board and to a mock in the host tests.
namespace cpu {

/// Keeps interrupts away, so that nothing can come between the look whether there is work and the sleep.
void holdInterrupts();

/// Lets them come again.
void releaseInterrupts();

/// Lets interrupts come again and sleeps until one has come; one that waits already ends the sleep at once.
/// Timers, UART and pins stay awake.
void releaseInterruptsAndIdle();

}  // namespace cpu
}  // namespace javinolib
