package uppaal.promela;

/**
 * One joint move as a guarded command.
 *
 * @param guard a Promela expression
 * @param effect Promela statements, divided by semicolons
 */
record Command(String guard, String effect) {
}
