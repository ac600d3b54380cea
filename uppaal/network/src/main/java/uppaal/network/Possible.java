package uppaal.network;

import java.nio.IntBuffer;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.BiFunction;
import java.util.stream.Collectors;
import uppaal.language.Term;

/**
 * What who watches a network knows of it: all states in which it may be after what was seen. Some moves are seen, by a
 * name; the others pass unseen. That time passes is seen as {@link #SLOT}. Each is found once and kept, so that a
 * network that is watched often, by many, soon costs a look-up for each thing that is seen.
 */
public final class Possible {
    /** What it is seen as that a unit of time passes. */
    public static final String SLOT = "slot";

    private final Watch watch;
    private final Set<Node> states;
    private final Map<String, Seen> after = new HashMap<>();
    private final Map<List<Integer>, Seen> elapsed = new HashMap<>();
    private final Map<Term, Boolean> certain = new HashMap<>();
    private final Map<Term, Seen> only = new HashMap<>();
    private Set<String> visible;

    private Possible(Watch watch, Set<Node> states) {
        this.watch = watch;
        this.states = states;
    }

    /**
     * What follows from what was seen.
     *
     * @param possible what is known now; nothing where it cannot have been
     * @param edges which edges may have been taken: {@code automaton: source -> target, number among these}
     */
    public record Seen(Optional<Possible> possible, Set<String> edges) {
        private static final Seen NEVER = new Seen(Optional.empty(), Set.of());
    }

    /**
     * What is known at first.
     *
     * @param covering whether the edges of what passes unseen are wanted too, which takes its time
     * @param name what a move out of a state is seen as; nothing where it is not seen
     */
    public static Possible first(Network network, boolean covering,
            BiFunction<int[], JointMove, Optional<String>> name) {
        Watch watch = new Watch(network, covering, name);
        return watch.known(watch.closed(Set.of(watch.node(network.initial()))));
    }

    /** What is known once a move was seen; nothing where it cannot have been. */
    public Optional<Possible> after(String name) {
        return see(name).possible();
    }

    /** As {@link #after}, with the edges. */
    public Seen see(String name) {
        synchronized (watch) {
            return after.computeIfAbsent(name, this::find);
        }
    }

    /** What is known after so many units of time, from the least to the most; nothing where they cannot have passed. */
    public Seen elapse(int least, int most) {
        synchronized (watch) {
            return elapsed.computeIfAbsent(List.of(least, most), key -> wait(least, most));
        }
    }

    private Seen wait(int least, int most) {
        List<Possible> found = new ArrayList<>();
        Set<String> edges = new HashSet<>();
        Possible now = this;
        for (int units = 0; units <= most; units++) {
            if (units >= least) {
                found.add(now);
            }
            Seen next = now.see(SLOT);
            if (next.possible().isEmpty() || next.possible().get() == now && units >= least) {
                break;
            }
            edges.addAll(next.edges());
            now = next.possible().get();
        }
        return found.isEmpty() ? Seen.NEVER : new Seen(Optional.of(watch.either(found)), edges);
    }

    /** What is known where a move may have been made, or not. */
    public Possible perhaps(String name) {
        synchronized (watch) {
            return after(name).map(moved -> watch.either(List.of(this, moved))).orElse(this);
        }
    }

    /** What is known where a move is made if it can be. */
    public Possible where(String name) {
        synchronized (watch) {
            Set<Node> others = new HashSet<>();
            for (Node state : states) {
                if (watch.after(state, name).length == 0) {
                    others.add(state);
                }
            }
            List<Possible> both = new ArrayList<>();
            after(name).ifPresent(both::add);
            if (!others.isEmpty()) {
                both.add(watch.known(others));
            }
            return watch.either(both);
        }
    }

    /** What is known where a formula is true; as before, where it cannot be. */
    public Seen only(Term formula) {
        synchronized (watch) {
            return only.computeIfAbsent(formula, term -> {
                Set<Node> kept = states.stream().filter(state -> term.holds(state.values)).collect(Collectors.toSet());
                return kept.isEmpty() ? new Seen(Optional.of(this), Set.of())
                        : new Seen(Optional.of(watch.known(kept)), watch.covering ? waysTo(kept) : Set.of());
            });
        }
    }

    /** Whether a formula is true in all these states. */
    public boolean isCertain(Term formula) {
        synchronized (watch) {
            return certain.computeIfAbsent(formula, term -> states.stream().allMatch(
                    state -> term.holds(state.values)));
        }
    }

    /** The names of the moves that can be seen next, in alphabetical order; that time passes is none. */
    public Set<String> next() {
        synchronized (watch) {
            if (visible == null) {
                visible = new TreeSet<>();
                for (Node state : states) {
                    watch.moves(state).forEach(
                            move -> move.name.filter(name -> !name.equals(SLOT)).ifPresent(visible::add));
                }
            }
            return Set.copyOf(visible);
        }
    }

    private Seen find(String name) {
        Set<Node> moved = new HashSet<>();
        Set<Node> origins = new HashSet<>();
        for (Node state : states) {
            Node[] after = watch.after(state, name);
            if (after.length != 0) {
                origins.add(state);
                moved.addAll(Arrays.asList(after));
            }
        }
        if (moved.isEmpty()) {
            return Seen.NEVER;
        }
        return new Seen(Optional.of(watch.known(moved)), watch.covering ? edges(name, origins) : Set.of());
    }

    private Set<String> edges(String name, Set<Node> origins) {
        Set<String> edges = waysTo(origins);
        for (Node state : origins) {
            watch.moves(state).stream().filter(move -> move.isSeen(name)).forEach(move -> edges.addAll(move.edges));
        }
        return edges;
    }

    /** The edges on unseen ways that lead to some of these states. */
    private Set<String> waysTo(Set<Node> wanted) {
        Map<Node, List<Node>> before = new HashMap<>();
        Map<Node, Set<String>> into = new HashMap<>();
        for (Node state : states) {
            for (Move move : watch.moves(state)) {
                if (move.name.isEmpty()) {
                    before.computeIfAbsent(move.target, target -> new ArrayList<>()).add(state);
                    into.computeIfAbsent(move.target, target -> new HashSet<>()).addAll(move.edges);
                }
            }
        }
        Set<String> edges = new HashSet<>();
        Set<Node> reached = new HashSet<>(wanted);
        Deque<Node> open = new ArrayDeque<>(wanted);
        while (!open.isEmpty()) {
            Node state = open.remove();
            edges.addAll(into.getOrDefault(state, Set.of()));
            for (Node earlier : before.getOrDefault(state, List.of())) {
                if (reached.add(earlier)) {
                    open.add(earlier);
                }
            }
        }
        return edges;
    }

    /** A move out of a state. */
    private record Move(Optional<String> name, Node target, List<String> edges) {
        boolean isSeen(String wanted) {
            return name.isPresent() && name.get().equals(wanted);
        }
    }

    /** A state, of which there is one only: so it is told from others by what it is, and not by all its values. */
    private static final class Node {
        private final int[] values;
        private final Map<String, Node[]> after = new HashMap<>();
        private List<Move> moves;

        Node(int[] values) {
            this.values = values;
        }
    }

    /** What all that watch one network share. */
    private static final class Watch {
        private final Successors steps;
        private final BiFunction<int[], JointMove, Optional<String>> name;
        private final boolean covering;
        private final Map<Transition, String> edges = new IdentityHashMap<>();
        private final Map<IntBuffer, Node> nodes = new HashMap<>();
        private final Map<Set<Node>, Possible> known = new HashMap<>();

        Watch(Network network, boolean covering, BiFunction<int[], JointMove, Optional<String>> name) {
            this.steps = new Successors(network);
            this.name = name;
            this.covering = covering;
            for (Automaton automaton : network.automata()) {
                Map<String, Integer> numbers = new HashMap<>();
                for (Transition transition : automaton.transitions()) {
                    String path = automaton.locations().get(transition.source()).name() + " -> "
                            + automaton.locations().get(transition.target()).name();
                    edges.put(transition, automaton.name() + ": " + path + ", " + numbers.merge(path, 1, Integer::sum));
                }
            }
        }

        Possible known(Set<Node> states) {
            return known.computeIfAbsent(states, added -> new Possible(this, added));
        }

        Possible either(Collection<Possible> several) {
            Set<Node> all = new HashSet<>();
            several.forEach(possible -> all.addAll(possible.states));
            return known(all);
        }

        /** The one that stands for a state. */
        Node node(int[] values) {
            return nodes.computeIfAbsent(IntBuffer.wrap(values), added -> new Node(values));
        }

        /** Where it may be after a move, and what passes unseen then. */
        Node[] after(Node state, String seen) {
            return state.after.computeIfAbsent(seen, added -> closed(moves(state).stream()
                    .filter(move -> move.isSeen(seen)).map(Move::target).collect(Collectors.toSet()))
                    .toArray(Node[]::new));
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
                found.add(new Move(move.passesTime() ? Optional.of(SLOT) : name.apply(state.values, move),
                        node(target), parts.stream().map(part -> edges.get(part.transition())).toList()));
            });
            if (idle) {
                found.add(new Move(Optional.of(SLOT), state, List.of()));
            }
            return found;
        }

        /** These states, and all to which moves lead from there that are not seen. */
        Set<Node> closed(Set<Node> states) {
            Set<Node> closed = new HashSet<>(states);
            Deque<Node> open = new ArrayDeque<>(states);
            while (!open.isEmpty()) {
                for (Move move : moves(open.remove())) {
                    if (move.name.isEmpty() && closed.add(move.target)) {
                        open.add(move.target);
                    }
                }
            }
            return closed;
        }
    }
}
