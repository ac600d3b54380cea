package uppaal.document;

/**
 * A location of a template.
 *
 * @param name its name, or its id where the file gives no name
 * @param committed whether it must be left by the very next move
 * @param invariant what must be true as long as an automaton is here, empty for nothing
 */
public record Location(String name, boolean committed, String invariant) {
}
