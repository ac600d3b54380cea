package uppaal.network;

import java.util.List;
import java.util.Optional;
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
 * @param assignments what it changes, in this order
 */
public record Transition(int source, int target, Term guard, Optional<Labels.Synchronisation> synchronisation,
        List<Labels.Assignment> assignments) {
    /** Copies the list, so that a transition never changes. */
    public Transition {
        assignments = List.copyOf(assignments);
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
    boolean urgent() {
        return synchronisation.isPresent() && synchronisation.get().channel().urgent();
    }

    /** Whether it has {@code channel?}. */
    public boolean receives(Symbol.Channel channel) {
        return synchronisation.isPresent() && !synchronisation.get().sends()
                && synchronisation.get().channel().equals(channel);
    }
}
