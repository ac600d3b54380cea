package uppaal.network;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.BiFunction;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import uppaal.language.Term;
import uppaal.network.Observer.Move;
import uppaal.network.Observer.Node;

/**
 * What who watches a network knows of it: all states in which it may be after what was seen. Some moves are seen, by a
 * name; the others pass unseen. That time passes is seen as {@link #SLOT}. Each is found once and kept, so that a
 * network that is watched often, by many, soon costs a look-up for each thing that is seen.
 */
public final class StateSet {
    /** What it is seen as that a unit of time passes. */
    public static final String SLOT = "slot";

    private final Observer watch;
    /** All that were found. */
    private final Set<Node> all;
    /** Those that stand for all. */
    private final Set<Node> states;
    private final Map<String, Seen> after = new HashMap<>();
    private final Map<List<Integer>, Seen> elapsed = new HashMap<>();
    private final Map<Term, Boolean> certain = new HashMap<>();
    private final Map<Term, Seen> only = new HashMap<>();
    private Set<String> visible;

    StateSet(Observer watch, Set<Node> all, Set<Node> states) {
        this.watch = watch;
        this.all = all;
        this.states = states;
    }

    /**
     * What follows from what was seen.
     *
     * @param possible what is known now; nothing where it cannot have been
     * @param edges which edges may have been taken: {@code automaton: source -> target, number among these}
     */
    public record Seen(Optional<StateSet> possible, Set<String> edges) {
        private static final Seen NEVER = new Seen(Optional.empty(), Set.of());
    }

    /**
     * What is known at first.
     *
     * @param observed all formulas that are asked of what is known
     * @param name what a move out of a state is seen as; nothing where it is not seen
     */
    public static StateSet first(Network network, Collection<Term> observed,
            BiFunction<int[], JointMove, Optional<String>> name) {
        Observer watch = new Observer(Slice.of(network, observed), name);
        return watch.known(List.of(watch.closed(List.of(watch.node(network.initial())))));
    }

    /** How many states all hold that watch this network, each counted as often as it is held. */
    public int size() {
        return watch.size();
    }

    /** Forgets what all of them have found: it is found again once it is asked for. */
    public void forget() {
        watch.forget();
    }

    void forgetNext() {
        after.clear();
        elapsed.clear();
        only.clear();
    }

    /** What is known once a move was seen; nothing where it cannot have been. */
    public Optional<StateSet> after(String name) {
        return see(name).possible();
    }

    /** As {@link #after}, with the edges. */
    public Seen see(String name) {
        return after.computeIfAbsent(name, this::find);
    }

    /** What is known after so many units of time, from the least to the most; nothing where they cannot have passed. */
    public Seen elapse(int least, int most) {
        return elapsed.computeIfAbsent(List.of(least, most), key -> wait(least, most));
    }

    private Seen wait(int least, int most) {
        Antichain found = new Antichain(watch);
        List<Set<Node>> several = new ArrayList<>();
        Set<String> edges = new HashSet<>();
        StateSet now = this;
        for (int units = 0; units <= most; units++) {
            // Where nothing new was found, no later time finds more.
            if (units >= least && !found.add(now.states)) {
                break;
            }
            if (units >= least) {
                several.add(now.all);
            }
            Seen next = now.see(SLOT);
            if (next.possible().isEmpty()) {
                break;
            }
            edges.addAll(next.edges());
            now = next.possible().get();
        }
        return several.isEmpty() ? Seen.NEVER : new Seen(Optional.of(watch.known(several)), edges);
    }

    /** What is known where a move may have been made, or not. */
    public StateSet perhaps(String name) {
        return after(name).map(this::or).orElse(this);
    }

    /** What is known where this is, or the other. */
    public StateSet or(StateSet other) {
        return watch.known(List.of(all, other.all));
    }

    /** What is known where a move is made if it can be; no clock may decide about that. */
    public StateSet where(String name) {
        Set<Node> moved = after(name).map(possible -> possible.all).orElse(Set.of());
        return watch.known(List.of(moved, kept(state -> watch.after(state, name).isEmpty())));
    }

    /** What is known where a formula is true; as before, where it cannot be. */
    public Seen only(Term formula) {
        return only.computeIfAbsent(formula, term -> {
            Set<Node> kept = kept(state -> term.holds(state.values()));
            return kept.isEmpty() ? new Seen(Optional.of(this), Set.of())
                    : new Seen(Optional.of(watch.known(List.of(kept))), waysTo(kept));
        });
    }

    private Set<Node> kept(Predicate<Node> wanted) {
        return all.stream().filter(wanted).collect(Collectors.toSet());
    }

    /** Whether a formula is true in all these states. */
    public boolean isCertain(Term formula) {
        return certain.computeIfAbsent(formula, term -> states.stream().allMatch(
                state -> term.holds(state.values())));
    }

    /** The names of the moves that can be seen next, in alphabetical order; that time passes is none. */
    public Set<String> next() {
        if (visible == null) {
            visible = new TreeSet<>();
            for (Node state : states) {
                watch.moves(state).forEach(
                        move -> move.name().filter(name -> !name.equals(SLOT)).ifPresent(visible::add));
            }
        }
        return Set.copyOf(visible);
    }

    private Seen find(String name) {
        List<Set<Node>> moved = new ArrayList<>();
        states.stream().map(state -> watch.after(state, name)).filter(after -> !after.isEmpty()).forEach(moved::add);
        return moved.isEmpty() ? Seen.NEVER : new Seen(Optional.of(watch.known(moved)), edges(name));
    }

    private Set<String> edges(String name) {
        Set<Node> origins = kept(state -> !watch.after(state, name).isEmpty());
        Set<String> edges = waysTo(origins);
        for (Node state : origins) {
            watch.moves(state).stream().filter(move -> move.isSeen(name))
                    .forEach(move -> edges.addAll(move.edges()));
        }
        return edges;
    }

    /** The edges on unseen ways that lead to some of these states. */
    private Set<String> waysTo(Set<Node> wanted) {
        Map<Node, List<Node>> before = new HashMap<>();
        Map<Node, Set<String>> into = new HashMap<>();
        for (Node state : all) {
            for (Move move : watch.moves(state)) {
                if (move.name().isEmpty()) {
                    before.computeIfAbsent(move.target(), target -> new ArrayList<>()).add(state);
                    into.computeIfAbsent(move.target(), target -> new HashSet<>()).addAll(move.edges());
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
}
