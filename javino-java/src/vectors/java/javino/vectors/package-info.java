/**
 * Makes the test vectors of both codecs from SPEC.md and the NIST standards, by means of its own:
 * nothing here uses {@code javino.protocol}, so that the vectors test it too.
 */
package javino.vectors;
