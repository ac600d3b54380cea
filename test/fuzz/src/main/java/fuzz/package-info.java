/** Targets for Jazzer: each takes any bytes, and fails where a decoder throws or says what SPEC.md does not. */
package fuzz;
