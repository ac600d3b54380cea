/** Packets for Wireshark: {@code javino capture} (SPEC 10). */
package capture;
