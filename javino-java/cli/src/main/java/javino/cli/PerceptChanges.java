package javino.cli;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/** The changes from one set of percepts to the next, in the signs of AgentSpeak's events. */
final class PerceptChanges {

    private Set<String> present = Set.of();

    /** First what holds no longer, as {@code -light(311)}, then what is new, as {@code +light(312)}. */
    List<String> to(List<String> literals) {
        Set<String> next = new LinkedHashSet<>(literals);
        List<String> changes = new ArrayList<>();
        present.stream().filter(literal -> !next.contains(literal)).forEach(gone -> changes.add("-" + gone));
        next.stream().filter(literal -> !present.contains(literal)).forEach(come -> changes.add("+" + come));
        present = next;
        return changes;
    }
}
