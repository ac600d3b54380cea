package uppaal.network;

import java.nio.IntBuffer;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.BiFunction;

/**
 * What who watches a network knows of it: all states in which it may be after what was seen. Some moves are seen, by a
 * name; the others, and time, pass unseen. Each is found once and kept, so that a network that is watched often, by
 * many, soon costs a look-up for each thing that is seen.
 */
public final class Possible {
    private final Watch watch;
    private final Set<IntBuffer> states;
    private final Map<String, Optional<Possible>> after = new HashMap<>();
    private Set<String> visible;

    private Possible(Watch watch, Set<IntBuffer> states) {
        this.watch = watch;
        this.states = states;
    }

    /**
     * What is known at first.
     *
     * @param name what a move out of a state is seen as; nothing where it is not seen
     */
    public static Possible first(Network network, BiFunction<int[], JointMove, Optional<String>> name) {
        Watch watch = new Watch(new Successors(network), name);
        return watch.known(watch.closed(Set.of(IntBuffer.wrap(network.initial()))));
    }

    /** As {@link #first(Network, BiFunction)}, where a move is seen as its channel, and nothing else is. */
    public static Possible first(Network network) {
        return first(network, (state, move) -> move.channel().map(channel -> channel.name()));
    }

    /** What is known once a move was seen; nothing where it cannot have been. */
    public Optional<Possible> after(String name) {
        synchronized (watch) {
            return after.computeIfAbsent(name, this::find);
        }
    }

    /** What is known where a move may have been made, or not. */
    public Possible perhaps(String name) {
        synchronized (watch) {
            Set<IntBuffer> both = new HashSet<>(states);
            after(name).ifPresent(moved -> both.addAll(moved.states));
            return watch.known(both);
        }
    }

    /** The names of the moves that can be seen next, in alphabetical order. */
    public Set<String> next() {
        synchronized (watch) {
            if (visible == null) {
                visible = new TreeSet<>();
                for (IntBuffer state : states) {
                    watch.steps.of(state.array())
                            .forEach(move -> watch.name.apply(state.array(), move).ifPresent(visible::add));
                }
            }
            return Set.copyOf(visible);
        }
    }

    private Optional<Possible> find(String name) {
        Set<IntBuffer> moved = new HashSet<>();
        for (IntBuffer state : states) {
            for (JointMove move : watch.steps.of(state.array())) {
                if (watch.name.apply(state.array(), move).filter(name::equals).isPresent()) {
                    moved.add(IntBuffer.wrap(move.target()));
                }
            }
        }
        return moved.isEmpty() ? Optional.empty() : Optional.of(watch.known(watch.closed(moved)));
    }

    /** What all that watch one network share. */
    private static final class Watch {
        private final Successors steps;
        private final BiFunction<int[], JointMove, Optional<String>> name;
        private final Map<Set<IntBuffer>, Possible> known = new HashMap<>();

        Watch(Successors steps, BiFunction<int[], JointMove, Optional<String>> name) {
            this.steps = steps;
            this.name = name;
        }

        Possible known(Set<IntBuffer> states) {
            return known.computeIfAbsent(states, added -> new Possible(this, added));
        }

        /** These states, and all to which moves lead from there that are not seen. */
        Set<IntBuffer> closed(Set<IntBuffer> states) {
            Set<IntBuffer> closed = new HashSet<>(states);
            Deque<IntBuffer> open = new ArrayDeque<>(states);
            while (!open.isEmpty()) {
                int[] state = open.remove().array();
                for (JointMove move : steps.of(state)) {
                    IntBuffer target = IntBuffer.wrap(move.target());
                    if (name.apply(state, move).isEmpty() && closed.add(target)) {
                        open.add(target);
                    }
                }
            }
            return closed;
        }
    }
}
