/**
 * What a session has from its computer: links to a board, as a serial port or in memory for tests, which carry bytes
 * and know nothing of the protocol; and the time.
 */
package javino.link;
