#include "AskHardware.h"

#ifdef JAVINO_HAS_ASK_HARDWARE

// The timer of a sketch that names none.
#include "AskHardwareAvrTimer.h"

#endif
