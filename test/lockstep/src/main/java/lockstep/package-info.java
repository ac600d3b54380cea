/**
 * Hosts and emulated boards in one time, which stands still while a host thinks: a run is the same each time, to the
 * byte, on any machine, and a fault is found again from its seed. For tests alone, as its keys can be guessed.
 */
package lockstep;
