/**
 * Makes the test vectors from SPEC.md and the NIST standards, by means of its own:
 * nothing here uses {@code javino.protocol}, so that the vectors test it as they test the firmware.
 */
package javino.vectors;
