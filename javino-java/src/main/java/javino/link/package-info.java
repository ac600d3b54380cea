/** Ways to a board: a serial port, and an in-memory one for tests. Bytes only; no knowledge of the protocol. */
package javino.link;
