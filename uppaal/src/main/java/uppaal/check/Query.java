package uppaal.check;

/**
 * A property with its name and what we expect of it.
 *
 * @param name e.g. {@code P3}
 * @param expected whether it is to hold
 * @param sentence its meaning, in plain words
 * @param text the property as UPPAAL writes it, in one line
 * @param where file and line, for messages
 */
public record Query(String name, boolean expected, String sentence, String text, String where) {
}
