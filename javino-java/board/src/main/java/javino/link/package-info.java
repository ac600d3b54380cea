/** Links to a board: a serial port, and one in memory for tests. They carry bytes and know nothing of the protocol. */
package javino.link;
