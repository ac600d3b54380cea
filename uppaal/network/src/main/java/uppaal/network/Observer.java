package uppaal.network;

import java.nio.IntBuffer;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiFunction;
import java.util.stream.Collectors;

/** What all that watch one network share: its states and their moves, as far as they were looked at. */
final class Observer {
    private final Successors steps;
    private final Order order;
    private final BiFunction<int[], JointMove, Optional<String>> name;
    private final Map<Transition, String> edges = new IdentityHashMap<>();
    private final Map<IntBuffer, Node> nodes = new HashMap<>();
    private final Map<IntBuffer, Object> rests = new HashMap<>();
    private final Map<Set<Node>, StateSet> known = new HashMap<>();
    private int size;

    /** @see StateSet#first */
    Observer(Network network, BiFunction<int[], JointMove, Optional<String>> name) {
        this.steps = new Successors(network);
        this.order = new Order(network);
        this.name = name;
        for (Automaton automaton : network.automata()) {
            Map<String, Integer> numbers = new HashMap<>();
            for (Transition transition : automaton.transitions()) {
                String path = automaton.locations().get(transition.source()).name() + " -> "
                        + automaton.locations().get(transition.target()).name();
                edges.put(transition, automaton.name() + ": " + path + ", " + numbers.merge(path, 1, Integer::sum));
            }
        }
    }

    /** A move out of a state; nothing is its name where it passes unseen. */
    record Move(Optional<String> name, Node target, List<String> edges) {
        boolean isSeen(String wanted) {
            return name.isPresent() && name.get().equals(wanted);
        }
    }

    /** A state, of which there is one only: so it is told from others by what it is, and not by all its values. */
    static final class Node {
        private final int[] values;
        private final Object rest;
        private final Map<String, Set<Node>> after = new HashMap<>();
        private List<Move> moves;

        private Node(int[] values, Object rest) {
            this.values = values;
            this.rest = rest;
        }

        int[] values() {
            return values;
        }

        /** The same for states that differ in their clocks only. */
        Object rest() {
            return rest;
        }

        private void forget() {
            moves = null;
            after.clear();
        }
    }

    /** What is known where each of some states is possible. */
    StateSet known(Collection<? extends Collection<Node>> several) {
        Set<Node> all = several.stream().flatMap(Collection::stream).collect(Collectors.toSet());
        return known.computeIfAbsent(all, added -> {
            size += added.size();
            return new StateSet(this, added, only(added));
        });
    }

    /** How many states all that is known has, counted each time. */
    int size() {
        return size;
    }

    /** Forgets all that can be found again. */
    void forget() {
        known.values().forEach(StateSet::forgetNext);
        nodes.values().forEach(Node::forget);
        known.clear();
        nodes.clear();
        size = 0;
    }

    /** The one that stands for a state. */
    Node node(int[] values) {
        return nodes.computeIfAbsent(IntBuffer.wrap(values),
                added -> new Node(values, rests.computeIfAbsent(order.rest(values), rest -> new Object())));
    }

    /** Whether a state allows all that another with the same rest does. */
    boolean allows(Node state, Node other) {
        return order.allows(state.values, other.values);
    }

    /** Where it may be after a move, and what passes unseen then. */
    Set<Node> after(Node state, String seen) {
        return state.after.computeIfAbsent(seen, added -> closed(moves(state).stream()
                .filter(move -> move.isSeen(seen)).map(Move::target).toList()));
    }

    List<Move> moves(Node state) {
        if (state.moves == null) {
            state.moves = find(state);
        }
        return state.moves;
    }

    private List<Move> find(Node state) {
        List<Move> found = new ArrayList<>();
        boolean idle = steps.each(state.values, (parts, target) -> {
            JointMove move = new JointMove(parts, target);
            found.add(new Move(move.passesTime() ? Optional.of(StateSet.SLOT) : name.apply(state.values, move),
                    node(target), parts.stream().map(part -> edges.get(part.transition())).toList()));
        });
        if (idle) {
            found.add(new Move(Optional.of(StateSet.SLOT), state, List.of()));
        }
        return found;
    }

    /** These states, and all to which moves lead from there that are not seen. */
    Set<Node> closed(Collection<Node> states) {
        Set<Node> closed = new HashSet<>(states);
        Deque<Node> open = new ArrayDeque<>(closed);
        while (!open.isEmpty()) {
            for (Move move : moves(open.remove())) {
                if (move.name.isEmpty() && closed.add(move.target)) {
                    open.add(move.target);
                }
            }
        }
        return closed;
    }

    /** Those that stand for all of these: nothing can be seen in the others, or others allow the same. */
    private Set<Node> only(Collection<Node> states) {
        Antichain front = new Antichain(this);
        if (!front.add(states.stream().filter(this::isLasting).toList())) {
            front.add(states);
        }
        return front.states();
    }

    /** Whether something can be seen in a state before it is left. */
    private boolean isLasting(Node state) {
        return moves(state).isEmpty() || moves(state).stream().anyMatch(move -> move.name.isPresent());
    }
}
