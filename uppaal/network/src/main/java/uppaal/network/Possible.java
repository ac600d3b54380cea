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
import java.util.TreeSet;
import java.util.function.BiFunction;
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
    private final Set<IntBuffer> states;
    private final Map<String, Seen> after = new HashMap<>();
    private final Map<List<Integer>, Seen> elapsed = new HashMap<>();
    private final Map<Term, Boolean> certain = new HashMap<>();
    private Set<String> visible;

    private Possible(Watch watch, Set<IntBuffer> states) {
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
     * @param name what a move out of a state is seen as; nothing where it is not seen
     */
    public static Possible first(Network network, BiFunction<int[], JointMove, Optional<String>> name) {
        Watch watch = new Watch(network, name);
        return watch.known(watch.closed(Set.of(IntBuffer.wrap(network.initial()))));
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
            Set<IntBuffer> others = new HashSet<>();
            for (IntBuffer state : states) {
                if (watch.moves(state).stream().noneMatch(move -> move.name.filter(name::equals).isPresent())) {
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

    /** Whether a formula is true in all these states. */
    public boolean isCertain(Term formula) {
        synchronized (watch) {
            return certain.computeIfAbsent(formula, term -> states.stream().allMatch(
                    state -> term.holds(state.array())));
        }
    }

    /** The names of the moves that can be seen next, in alphabetical order; that time passes is none. */
    public Set<String> next() {
        synchronized (watch) {
            if (visible == null) {
                visible = new TreeSet<>();
                for (IntBuffer state : states) {
                    watch.moves(state).forEach(
                            move -> move.name.filter(name -> !name.equals(SLOT)).ifPresent(visible::add));
                }
            }
            return Set.copyOf(visible);
        }
    }

    private Seen find(String name) {
        Set<IntBuffer> moved = new HashSet<>();
        Set<IntBuffer> origins = new HashSet<>();
        Set<String> edges = new HashSet<>();
        for (IntBuffer state : states) {
            for (Move move : watch.moves(state)) {
                if (move.name.filter(name::equals).isPresent()) {
                    moved.add(move.target);
                    origins.add(state);
                    edges.addAll(move.edges);
                }
            }
        }
        if (moved.isEmpty()) {
            return Seen.NEVER;
        }
        edges.addAll(waysTo(origins));
        return new Seen(Optional.of(watch.known(watch.closed(moved))), edges);
    }

    /** The edges on unseen ways that lead to some of these states. */
    private Set<String> waysTo(Set<IntBuffer> wanted) {
        Map<IntBuffer, List<IntBuffer>> before = new HashMap<>();
        Map<IntBuffer, Set<String>> into = new HashMap<>();
        for (IntBuffer state : states) {
            for (Move move : watch.moves(state)) {
                if (move.name.isEmpty()) {
                    before.computeIfAbsent(move.target, target -> new ArrayList<>()).add(state);
                    into.computeIfAbsent(move.target, target -> new HashSet<>()).addAll(move.edges);
                }
            }
        }
        Set<String> edges = new HashSet<>();
        Set<IntBuffer> reached = new HashSet<>(wanted);
        Deque<IntBuffer> open = new ArrayDeque<>(wanted);
        while (!open.isEmpty()) {
            IntBuffer state = open.remove();
            edges.addAll(into.getOrDefault(state, Set.of()));
            for (IntBuffer earlier : before.getOrDefault(state, List.of())) {
                if (reached.add(earlier)) {
                    open.add(earlier);
                }
            }
        }
        return edges;
    }

    /** A move out of a state. */
    private record Move(Optional<String> name, IntBuffer target, List<String> edges) {}

    /** What all that watch one network share. */
    private static final class Watch {
        private final Successors steps;
        private final BiFunction<int[], JointMove, Optional<String>> name;
        private final Map<Transition, String> edges = new IdentityHashMap<>();
        private final Map<IntBuffer, List<Move>> moves = new HashMap<>();
        private final Map<Set<IntBuffer>, Possible> known = new HashMap<>();

        Watch(Network network, BiFunction<int[], JointMove, Optional<String>> name) {
            this.steps = new Successors(network);
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

        Possible known(Set<IntBuffer> states) {
            return known.computeIfAbsent(states, added -> new Possible(this, added));
        }

        Possible either(Collection<Possible> several) {
            Set<IntBuffer> all = new HashSet<>();
            several.forEach(possible -> all.addAll(possible.states));
            return known(all);
        }

        List<Move> moves(IntBuffer state) {
            return moves.computeIfAbsent(state, this::find);
        }

        private List<Move> find(IntBuffer state) {
            List<Move> found = new ArrayList<>();
            boolean idle = steps.each(state.array(), (parts, target) -> {
                JointMove move = new JointMove(parts, target);
                found.add(new Move(move.passesTime() ? Optional.of(SLOT) : name.apply(state.array(), move),
                        IntBuffer.wrap(target), parts.stream().map(part -> edges.get(part.transition())).toList()));
            });
            if (idle) {
                found.add(new Move(Optional.of(SLOT), state, List.of()));
            }
            return found;
        }

        /** These states, and all to which moves lead from there that are not seen. */
        Set<IntBuffer> closed(Set<IntBuffer> states) {
            Set<IntBuffer> closed = new HashSet<>(states);
            Deque<IntBuffer> open = new ArrayDeque<>(states);
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
