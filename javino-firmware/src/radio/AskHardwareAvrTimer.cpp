#if defined(__AVR__)

// The timer of a sketch that names none.
#include "AskHardwareAvrTimer.h"

#endif
