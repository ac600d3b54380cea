package harness;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;

/** What a program has printed; a test waits, in its own time, for more. */
final class Lines {

    /** Long enough for a sketch to be built on a busy machine. */
    private static final Duration PATIENCE = Duration.ofMinutes(5);

    private final List<String> lines = new ArrayList<>();
    private final Changes changes = new Changes();

    void add(String line) {
        changes.change(() -> lines.add(line));
    }

    List<String> all() {
        synchronized (changes) {
            return List.copyOf(lines);
        }
    }

    long count(Predicate<String> wanted) {
        return all().stream().filter(wanted).count();
    }

    /** Waits for the n-th line, since the beginning, that is as wanted. */
    void await(String what, int nth, Predicate<String> wanted) throws InterruptedException {
        changes.await(() -> "not " + nth + " times " + what + ":\n" + String.join("\n", all()), PATIENCE,
                () -> count(wanted) < nth ? null : what);
    }
}
