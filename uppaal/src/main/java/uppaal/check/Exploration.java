package uppaal.check;

import java.nio.IntBuffer;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
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
    /** In the order of finding. */
    private final List<int[]> states = new ArrayList<>();
    /** The number of the state that each was first reached from. */
    private final List<Integer> parents = new ArrayList<>();
    private final Set<IntBuffer> known = new HashSet<>();
    private final int[] settled;
    private int deadlocks;

    private Exploration(Network network, List<Property> properties) {
        this.network = network;
        this.properties = List.copyOf(properties);
        this.successors = new Successors(network);
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
        return states.size();
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
     * Explores until one of the properties is settled by a state, for the evidence alone: numbers of states and
     * deadlocks, and verdicts of the others, say nothing.
     */
    public static Exploration untilSettled(Network network, List<Property> properties) {
        Exploration exploration = new Exploration(network, properties);
        exploration.add(network.initial(), NOWHERE);
        for (int number = 0; number < exploration.states() && !exploration.anySettled(); number++) {
            exploration.visit(number);
        }
        return exploration;
    }

    private boolean anySettled() {
        return Arrays.stream(settled).anyMatch(state -> state != NOWHERE);
    }

    private void run() {
        add(network.initial(), NOWHERE);
        for (int number = 0; number < states(); number++) {
            visit(number);
        }
    }

    private void add(int[] state, int parent) {
        if (known.add(IntBuffer.wrap(state))) {
            states.add(state);
            parents.add(parent);
        }
    }

    private void visit(int number) {
        int[] state = states.get(number);
        List<JointMove> moves = possible(state);
        for (JointMove move : moves) {
            add(move.target(), number);
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
        for (int at = number; parents.get(at) != NOWHERE; at = parents.get(at)) {
            int[] target = states.get(at);
            moves.addFirst(successors.of(states.get(parents.get(at))).stream()
                    .filter(move -> Arrays.equals(move.target(), target)).findFirst().orElseThrow());
        }
        return new Trace(network, List.copyOf(moves), states.get(number));
    }
}
