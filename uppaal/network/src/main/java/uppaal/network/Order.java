package uppaal.network;

import java.nio.IntBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Which of two states that differ in their clocks only allows all that the other does: each of its clocks shows the
 * same; or less, but no less than what may be waited for; or more, where it is too late in the other, too, for all that
 * may be too late (the lower and upper bounds of Behrmann, Bouyer, Larsen and Pelánek, 2004).
 */
final class Order {
    private final List<Limited> clocks = new ArrayList<>();

    /**
     * A clock.
     *
     * @param automaton the slot of the location that its limits depend on
     * @param byLocation those that are ahead at each of its locations
     */
    private record Limited(int slot, int automaton, Limits[] byLocation) {
        Limits at(int[] state) {
            return byLocation[state[automaton]];
        }
    }

    Order(Network network) {
        for (int slot = 0; slot < network.slots().size(); slot++) {
            if (network.slots().get(slot).clock()) {
                clocks.add(limited(network, slot));
            }
        }
    }

    private static Limited limited(Network network, int clock) {
        // Others may reset a global one: where an automaton is does not matter.
        Automaton owner = network.owner(clock).orElse(network.automata().get(0));
        Limits all = network.automata().stream().flatMap(automaton -> locations(automaton)
                .mapToObj(location -> automaton.limits(location, clock))).reduce(Limits.NONE, Limits::and);
        return new Limited(clock, owner.slot(), locations(owner)
                .mapToObj(location -> owner.owns(clock) ? owner.limits(location, clock) : all)
                .toArray(Limits[]::new));
    }

    private static IntStream locations(Automaton automaton) {
        return IntStream.range(0, automaton.locations().size());
    }

    /** A state without its clocks. */
    IntBuffer rest(int[] state) {
        int[] rest = state.clone();
        clocks.forEach(clock -> rest[clock.slot] = 0);
        return IntBuffer.wrap(rest);
    }

    /** Whether a state allows all that another with the same rest does. */
    boolean allows(int[] state, int[] other) {
        for (Limited clock : clocks) {
            if (!clock.at(state).allows(state[clock.slot], other[clock.slot])) {
                return false;
            }
        }
        return true;
    }
}
