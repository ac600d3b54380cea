package uppaal.check;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import uppaal.language.Labels;
import uppaal.language.Symbol;
import uppaal.network.Automaton;
import uppaal.network.Transition;

/**
 * A step of the network: one transition alone, a sender's with those of its receivers, or waiting.
 *
 * @param parts the sender's part first, then the receivers' in the order of the system line; none where a unit of time
 *     passes
 * @param target the state that it leads to
 */
public record JointMove(List<Part> parts, int[] target) {
    /** One automaton's part in a step. */
    public record Part(Automaton automaton, Transition transition) {
        @Override
        public String toString() {
            return automaton.name() + " " + automaton.locations().get(transition.source()).name()
                    + " -> " + automaton.locations().get(transition.target()).name();
        }
    }

    /** Whether nobody moves and one unit of time passes. */
    public boolean passesTime() {
        return parts.isEmpty();
    }

    /** The channel that was used, if any. */
    public Optional<Symbol.Channel> channel() {
        return passesTime() ? Optional.empty()
                : parts.get(0).transition().synchronisation().map(Labels.Synchronisation::channel);
    }

    @Override
    public String toString() {
        String label = channel().map(Symbol.Channel::name).orElse("(alone)");
        return String.format("%-18s ", label) + parts.stream().map(Part::toString).collect(Collectors.joining(", "));
    }
}
