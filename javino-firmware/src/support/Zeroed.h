#pragma once

/// The initial value of a member that begins as 0, false or null, in a class of whose objects each lives as long as the
/// program.
///
/// On an AVR these are global or static objects, whose memory the start-up code clears: that the constructors do not clear it
/// once more saves 430 bytes of Vehicle's flash. Elsewhere, as in the tests, an object may lie in any memory.
#ifdef __AVR__
#define JAVINO_ZEROED
#else
#define JAVINO_ZEROED = {}
#endif
