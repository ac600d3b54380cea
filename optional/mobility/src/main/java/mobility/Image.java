package mobility;

/**
 * The two texts in which an agent travels (SPEC 9.4).
 *
 * @param program its rules and plans.
 * @param state   its beliefs, events and intentions.
 */
record Image(String program, String state) {
}
