#pragma once

/// Marks a function that link-time optimisation must not merge into its only caller, as the caller's stack frame, which then
/// has the keys or buffers of both, would be held while other functions need the stack. Also marks small functions whose copies
/// in their callers would take more flash than the calls.
#define JAVINO_NOINLINE __attribute__((noinline))

/// Keeps a function one function. Where gcc sees the whole program, it copies a method that is called for one object only
/// and puts the object's address into the copy: then each access to a field takes 4 bytes of flash instead of 2.
#define JAVINO_OUT_OF_LINE __attribute__((noinline, noclone))

/// The same for a method that may become part of its caller, whose pointer to the object it then uses.
#define JAVINO_NOCLONE __attribute__((noclone))

/// Has a small method put into each caller, whose object is then in registers and not in memory. gcc counts only its length.
#define JAVINO_INLINE inline __attribute__((always_inline))
