/** SPEC.md as hosts read and write it: addresses, frames, packets, commands, contents. No I/O; immutable values. */
package javino.protocol;
