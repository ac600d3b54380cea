package uppaal.document;

/**
 * An edge of a template. A label that the file does not have is empty.
 *
 * @param source name of the location that it leaves
 * @param target name of the location that it enters
 * @param guard when it may be taken
 * @param synchronisation {@code channel!} or {@code channel?}
 * @param assignment what it changes
 */
public record Edge(String source, String target, String guard, String synchronisation, String assignment) {
    /** This edge with another synchronisation; empty for none. */
    public Edge withSynchronisation(String changed) {
        return new Edge(source, target, guard, changed, assignment);
    }

    /** Where it leads: {@code Idle -> Connected}. */
    public String path() {
        return source + " -> " + target;
    }
}
