#include "../storage/Retained.h"

#ifdef __AVR__
#define JAVINO_RETAINED __attribute__((section(".noinit")))
#else
#define JAVINO_RETAINED
#endif

namespace javino {
namespace retained {

// The start-up code clears .bss and fills .data, but leaves .noinit, which the linker places right behind them. On a Mega
// the boot loader runs before each start-up: its own variables lie at the bottom of the RAM, its stack at the top; what
// is in the middle, above some hundred bytes of .data and .bss, it does not touch.
static TakenNonces nonces JAVINO_RETAINED;

TakenNonces &takenNonces() { return nonces; }

}  // namespace retained
}  // namespace javino
