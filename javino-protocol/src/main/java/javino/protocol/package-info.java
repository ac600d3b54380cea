/** What hosts read and write of SPEC.md: addresses, frames, packets, commands, contents. No I/O; immutable values. */
package javino.protocol;
