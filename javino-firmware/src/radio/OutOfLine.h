#pragma once

/// Keeps a function one function. Where gcc sees the whole program, it copies a method that is called for one object only
/// and puts the object's address into the copy: then each access to a field takes 4 bytes of flash instead of 2.
#define JAVINO_OUT_OF_LINE __attribute__((noinline, noclone))
