/**
 * The bytes of the older public Javino protocol (SPEC 8), which boards speak that were flashed with its library; no
 * I/O.
 */
package javino.legacy;
