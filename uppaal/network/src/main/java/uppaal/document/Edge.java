package uppaal.document;

/**
 * An edge of a template. A label that the file does not have is empty.
 *
 * @param source name of the location that it leaves
 * @param target name of the location that it enters
 * @param guard when it may be taken
 * @param synchronisation {@code channel!} or {@code channel?}
 * @param assignment the changes that it makes
 * @param points the trace points that boards take it at, with spaces between them
 */
public record Edge(String source, String target, String guard, String synchronisation, String assignment,
        String points) {
    /** An edge that no trace shows. */
    public Edge(String source, String target, String guard, String synchronisation, String assignment) {
        this(source, target, guard, synchronisation, assignment, "");
    }

    /** This edge with another synchronisation; empty for none. */
    public Edge withSynchronisation(String changed) {
        return new Edge(source, target, guard, changed, assignment, points);
    }

    /** The way that it leads: {@code Idle -> Connected}. */
    public String path() {
        return source + " -> " + target;
    }
}
