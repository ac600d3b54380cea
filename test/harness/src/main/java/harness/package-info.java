/** The parts of whole-system tests: the emulator with a scenario, hosts, an attacker's transmitter, keys for tests. */
package harness;
