package uppaal.network;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import uppaal.language.Labels;
import uppaal.language.Symbol;
import uppaal.language.Term;

/**
 * An edge of an automaton that runs.
 *
 * @param source index of the location that it leaves
 * @param target index of the location that it enters
 * @param guard when it may be taken
 * @param synchronisation empty for a move that the automaton makes alone
 * @param assignments the changes that it makes, in this order
 * @param points the trace points that boards take it at
 */
public record Transition(int source, int target, Term guard, Optional<Labels.Synchronisation> synchronisation,
        List<Labels.Assignment> assignments, Set<String> points) {
    /** Copies the collections, so that a transition never changes. */
    public Transition {
        assignments = List.copyOf(assignments);
        points = Set.copyOf(points);
    }

    /** The same transition, but that it makes these assignments. */
    public Transition assigning(List<Labels.Assignment> changed) {
        return new Transition(source, target, guard, synchronisation, changed, points);
    }

    /** Whether it needs no other automaton. */
    public boolean internal() {
        return synchronisation.isEmpty();
    }

    /** Whether it has {@code !}. */
    public boolean sends() {
        return synchronisation.isPresent() && synchronisation.get().sends();
    }

    /** Whether no time passes while it can be taken. */
    public boolean urgent() {
        return synchronisation.isPresent() && synchronisation.get().channel().urgent();
    }

    /** Whether it has {@code channel?}. */
    public boolean receives(Symbol.Channel channel) {
        return synchronisation.isPresent() && !synchronisation.get().sends()
                && synchronisation.get().channel().equals(channel);
    }
}
