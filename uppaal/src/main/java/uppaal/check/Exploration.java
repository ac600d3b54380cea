package uppaal.check;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import uppaal.ModelException;
import uppaal.network.Network;

/** All reachable states of a network, found breadth first, and what they say of some properties. */
public final class Exploration {
    private static final int NOWHERE = -1;

    private final Network network;
    private final List<Property> properties;
    private final Successors successors;
    /** The states, in the order of finding. */
    private final States states;
    /** The number of the state that each was first reached from. */
    private int[] parents = new int[1 << 10];
    private final int[] settled;
    /** A check for each property that speaks of whole runs, at its index; else nothing. */
    private final LivenessCheck[] endless;
    /** The graph, kept only for these properties. */
    private final Optional<Graph> graph;
    private int deadlocks;
    private int steps;

    private Exploration(Network network, List<Property> properties) {
        this.network = network;
        this.properties = List.copyOf(properties);
        this.successors = new Successors(network);
        this.states = new States(network.slots());
        this.settled = new int[properties.size()];
        Arrays.fill(settled, NOWHERE);
        this.graph = properties.stream().anyMatch(Property::ofRuns) ? Optional.of(new Graph()) : Optional.empty();
        this.endless =
                properties.stream().map(property -> property.ofRuns() ? new LivenessCheck(graph.orElseThrow()) : null)
                        .toArray(LivenessCheck[]::new);
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
        if (endless[property] != null) {
            return endless[property].found().isEmpty();
        }
        boolean found = settled[property] != NOWHERE;
        return found == (properties.get(property).quantifier() == Property.Quantifier.POSSIBLY);
    }

    /**
     * A shortest way to a state that refutes {@code A[]} or shows {@code E<>}, or a run that refutes {@code A<>} or
     * {@code -->} (see {@link LivenessCheck}); empty when there is none.
     */
    public Optional<DiagnosticTrace> evidence(int property) {
        if (endless[property] != null) {
            return endless[property].found().map(run -> trace(run.states(),
                    run.loopStart() == NOWHERE ? DiagnosticTrace.Ending.STAYS : DiagnosticTrace.Ending.LOOPS,
                    run.loopStart()));
        }
        return settled[property] == NOWHERE ? Optional.empty()
                : Optional.of(trace(List.of(settled[property]), DiagnosticTrace.Ending.REACHED, NOWHERE));
    }

    private void run() {
        try {
            add(network.initial(), NOWHERE);
            int[] state = new int[network.slots().size() + 1];
            for (int number = 0; number < states(); number++) {
                states.read(number, state);
                visit(number, state);
            }
        } catch (ArithmeticException overflow) {
            throw new ModelException(network.file(), "a value does not fit 32 bits, or is divided by 0");
        }
    }

    private int add(int[] state, int parent) {
        int known = states.size();
        int number = states.add(state);
        if (number == known) {
            if (number == parents.length) {
                parents = Arrays.copyOf(parents, parents.length * 2);
            }
            parents[number] = parent;
        }
        return number;
    }

    /** @param state as queries see it: with {@code deadlock}, which is found out here */
    private void visit(int number, int[] state) {
        state[network.deadlockSlot()] = 0;
        steps = 0;
        boolean stays = successors.each(state, (parts, target) -> {
            int reached = add(target, number);
            graph.ifPresent(kept -> kept.lead(reached));
            steps++;
        });
        boolean deadlocked = steps == 0;
        deadlocks += deadlocked ? 1 : 0;
        graph.ifPresent(kept -> kept.next(deadlocked || stays));
        state[network.deadlockSlot()] = deadlocked ? 1 : 0;
        for (int i = 0; i < settled.length; i++) {
            Property property = properties.get(i);
            if (endless[i] != null) {
                endless[i].visit(number, property.begins(number == 0, state), property.formula().holds(state));
            } else if (settled[i] == NOWHERE && property.settledBy(state)) {
                settled[i] = number;
            }
        }
    }

    /** The way to the first of some states, and then through these. */
    private DiagnosticTrace trace(List<Integer> run, DiagnosticTrace.Ending ending, int loopStart) {
        ArrayDeque<Integer> numbers = new ArrayDeque<>();
        for (int at = parents[run.get(0)]; at != NOWHERE; at = parents[at]) {
            numbers.addFirst(at);
        }
        int before = numbers.size();
        numbers.addAll(run);
        List<JointMove> moves = new ArrayList<>();
        int[] state = state(numbers.removeFirst());
        for (int number : numbers) {
            int[] target = state(number);
            moves.add(successors.of(state).stream().filter(move -> Arrays.equals(move.target(), target)).findFirst()
                    .orElseThrow());
            state = target;
        }
        return new DiagnosticTrace(network, List.copyOf(moves), state, ending, before + loopStart);
    }

    private int[] state(int number) {
        int[] state = new int[network.slots().size()];
        states.read(number, state);
        return state;
    }
}
