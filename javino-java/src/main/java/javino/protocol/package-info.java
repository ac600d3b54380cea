/** The bytes of SPEC.md: addresses, frames, packets, commands, envelopes and the radio's line code. No I/O; all values immutable. */
package javino.protocol;
