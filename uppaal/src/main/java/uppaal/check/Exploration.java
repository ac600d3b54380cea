package uppaal.check;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import uppaal.ModelException;
import uppaal.network.JointMove;
import uppaal.network.Network;
import uppaal.network.Successors;

/** All reachable states of a network, found breadth first, and what they say of some properties. */
public final class Exploration {
    private static final int NOWHERE = -1;

    private final Network network;
    private final List<Property> properties;
    private final Successors successors;
    private final StateStore store;
    private final int[] settled;
    private int deadlocks;

    private Exploration(Network network, List<Property> properties) {
        this.network = network;
        this.properties = List.copyOf(properties);
        this.successors = new Successors(network);
        this.store = new StateStore(network.slots());
        this.settled = new int[properties.size()];
        Arrays.fill(settled, NOWHERE);
    }

    /**
     * Explores the whole network once for all properties.
     *
     * @throws ModelException when a variable would leave its range
     */
    public static Exploration of(Network network, List<Property> properties) {
        Exploration exploration = new Exploration(network, properties);
        exploration.run();
        return exploration;
    }

    /** How many states can be reached, the first included. */
    public int states() {
        return store.size();
    }

    /** How many of them have no next state. */
    public int deadlocks() {
        return deadlocks;
    }

    /** Whether the property of this index holds. */
    public boolean holds(int property) {
        boolean found = settled[property] != NOWHERE;
        return found == (properties.get(property).quantifier() == Property.Quantifier.POSSIBLY);
    }

    /** A shortest way to a state that refutes {@code A[]} or shows {@code E<>}; empty when there is none. */
    public Optional<Trace> evidence(int property) {
        return settled[property] == NOWHERE ? Optional.empty() : Optional.of(traceTo(settled[property]));
    }

    /**
     * Explores until one of the properties is settled by a state, for the evidence alone: numbers of states and deadlocks,
     * and verdicts of the others, say nothing.
     */
    public static Exploration untilSettled(Network network, List<Property> properties) {
        Exploration exploration = new Exploration(network, properties);
        exploration.store.add(network.initial(), NOWHERE);
        for (int number = 0; number < exploration.store.size() && !exploration.anySettled(); number++) {
            exploration.visit(number);
        }
        return exploration;
    }

    private boolean anySettled() {
        return Arrays.stream(settled).anyMatch(state -> state != NOWHERE);
    }

    private void run() {
        store.add(network.initial(), NOWHERE);
        for (int number = 0; number < store.size(); number++) {
            visit(number);
        }
    }

    private void visit(int number) {
        int[] state = store.get(number);
        List<JointMove> moves = possible(state);
        for (JointMove move : moves) {
            store.add(move.target(), number);
        }
        deadlocks += moves.isEmpty() ? 1 : 0;
        int[] observed = network.observed(state, moves.isEmpty());
        for (int i = 0; i < settled.length; i++) {
            if (settled[i] == NOWHERE && properties.get(i).settledBy(observed)) {
                settled[i] = number;
            }
        }
    }

    private List<JointMove> possible(int[] state) {
        try {
            return successors.of(state);
        } catch (ArithmeticException overflow) {
            throw new ModelException(network.file(), "a value does not fit 32 bits");
        }
    }

    private Trace traceTo(int number) {
        ArrayDeque<JointMove> moves = new ArrayDeque<>();
        for (int at = number; store.parent(at) != NOWHERE; at = store.parent(at)) {
            int[] target = store.get(at);
            moves.addFirst(successors.of(store.get(store.parent(at))).stream()
                .filter(move -> Arrays.equals(move.target(), target)).findFirst().orElseThrow());
        }
        return new Trace(network, List.copyOf(moves), store.get(number));
    }
}
