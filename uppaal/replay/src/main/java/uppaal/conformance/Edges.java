package uppaal.conformance;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;

/** {@code gradle :test:system:edges}: which edges of the models many runs together have taken, and which not. */
public final class Edges {
    private static final int ALL = 100;

    private Edges() {
    }

    /**
     * Ends with 0 where they have taken enough, else with 1.
     *
     * @param arguments a folder with a file for each run, in which each line is an edge; and how many percent are
     *                  enough
     */
    public static void main(String[] arguments) throws IOException {
        System.exit(run(Path.of(arguments[0]), Integer.parseInt(arguments[1])));
    }

    static int run(Path folder, int enough) throws IOException {
        Set<String> taken = new TreeSet<>();
        List<Path> runs;
        try (Stream<Path> files = Files.list(folder)) {
            runs = files.toList();
        }
        for (Path run : runs) {
            taken.addAll(Files.readAllLines(run));
        }
        // Chance decides the end of a move or a handshake: an edge that is not taken is told, and is no fault.
        count(runs.size() + " runs have taken", Replay.transitions(), taken, "of hosts");
        int count = count(runs.size() + " runs have taken", Replay.edges(), taken, "of the models");
        return count * ALL >= enough * Replay.edges().size() ? 0 : 1;
    }

    /** Says how many of some edges were taken, and which were not. */
    private static int count(String who, Set<String> edges, Set<String> taken, String what) {
        Set<String> missing = new TreeSet<>(edges);
        missing.removeAll(taken);
        missing.forEach(edge -> System.out.println("model: not taken: " + edge));
        int count = edges.size() - missing.size();
        System.out.println("model: " + who + " " + count + " of the " + edges.size() + " edges " + what);
        return count;
    }
}
