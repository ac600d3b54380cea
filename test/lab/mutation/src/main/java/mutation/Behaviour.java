package mutation;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import uppaal.ModelException;
import uppaal.check.Exploration;
import uppaal.check.Property;
import uppaal.check.Query;
import uppaal.check.States;
import uppaal.check.JointMove;
import uppaal.network.Network;
import uppaal.check.Successors;
import uppaal.network.Transition;

/**
 * The behaviour of a model: its states and moves, as far as needed to see a wrong verdict.
 *
 * @param wrong  the query whose verdict is not the expected one, or that a variable left its range; empty for none
 * @param states how many there are, or were seen until then
 * @param print  the same for models that have the same states and moves
 * @param whole  whether all states were seen
 */
record Behaviour(Optional<String> wrong, int states, long print, boolean whole) {

    static final String RANGE = "range";
    private static final long ODD = 0x9E3779B97F4A7C15L;
    private static final int HALF = 32;

    /**
     * Explores until a verdict is wrong.
     *
     * @param limit states after which it gives up
     */
    static Behaviour of(Network network, List<Query> queries, int limit) {
        return new WalkerLog(network, queries, limit).behaviour();
    }

    /** Whether a query asks something of single states. */
    static boolean isSettledByStates(Query query) {
        return query.text().startsWith("A[]") || query.text().startsWith("E<>");
    }

    private record Asked(Property property, Query query) {}

    /** One exploration, breadth first. */
    private static final class WalkerLog {
        private final Network network;
        private final Successors successors;
        private final int limit;
        /** The queries that single states settle. */
        private final List<Asked> open = new ArrayList<>();
        /** The other queries. */
        private final List<Query> more = new ArrayList<>();
        private final States states;
        private final Set<Long> moves = new HashSet<>();
        private String wrong;
        private long print;

        WalkerLog(Network network, List<Query> queries, int limit) {
            this.network = network;
            this.limit = limit;
            successors = new Successors(network);
            states = new States(network.slots());
            for (Query query : queries) {
                if (isSettledByStates(query)) {
                    open.add(new Asked(Property.parse(query.text(), network, query.where()), query));
                } else {
                    more.add(query);
                }
            }
        }

        Behaviour behaviour() {
            int number = 0;
            try {
                states.add(network.initial());
                int[] state = network.initial();
                for (; number < states.size() && states.size() <= limit && wrong == null; number++) {
                    states.read(number, state);
                    visit(state);
                }
                boolean whole = number == states.size();
                if (whole && wrong == null) {
                    open.forEach(asked -> judge(asked.query, !settlesToTrue(asked.property)));
                    later();
                }
                return new Behaviour(Optional.ofNullable(wrong), states.size(), print, whole);
            } catch (ModelException | ArithmeticException outOfRange) {
                return new Behaviour(Optional.of(RANGE), states.size(), print, false);
            }
        }

        private void visit(int[] state) {
            moves.clear();
            successors.each(state, (parts, target) -> {
                states.add(target);
                moves.add(hash(state, parts, target));
            });
            // A sum, since states are found in another order where edges stand in another.
            print += mixed(hash(state));
            for (long move : moves) {
                print += mixed(move);
            }
            int[] observed = network.observed(state, moves.isEmpty());
            for (int i = open.size() - 1; i >= 0; i--) {
                if (open.get(i).property.settledBy(observed)) {
                    Asked settled = open.remove(i);
                    judge(settled.query, settlesToTrue(settled.property));
                }
            }
        }

        /** The value of a property that a state settles; the opposite where none does. */
        private static boolean settlesToTrue(Property property) {
            return property.text().startsWith("E<>");
        }

        private void judge(Query query, boolean holds) {
            if (holds != query.expected() && wrong == null) {
                wrong = query.name();
            }
        }

        /** Judges the queries that no single state settles, such as that one thing leads to another. */
        private void later() {
            if (wrong != null || more.isEmpty()) {
                return;
            }
            Exploration exploration = Exploration.of(network,
                    more.stream().map(query -> Property.parse(query.text(), network, query.where())).toList());
            for (int i = 0; i < more.size(); i++) {
                judge(more.get(i), exploration.holds(i));
            }
        }

        private static long hash(int[] state, List<JointMove.Part> parts, int[] target) {
            long hash = hash(state) * ODD + hash(target);
            for (JointMove.Part part : parts) {
                Transition transition = part.transition();
                if (changesNothing(transition)) {
                    continue;
                }
                hash = mixed(hash) + part.automaton().slot();
                hash = mixed(hash) + transition.source();
                hash = mixed(hash) + transition.target();
                hash = mixed(hash)
                        + transition.synchronisation().map(sync -> sync.channel().name().hashCode()).orElse(1);
            }
            return hash;
        }

        /** An automaton that hears something and goes on as before might as well not have heard it. */
        private static boolean changesNothing(Transition transition) {
            return transition.source() == transition.target() && transition.assignments().isEmpty()
                    && !transition.sends()
                    && transition.synchronisation().map(sync -> sync.channel().broadcast()).orElse(false);
        }

        private static long hash(int[] state) {
            long hash = state.length;
            for (int value : state) {
                hash = mixed(hash + value) * ODD + 1;
            }
            return hash;
        }

        private static long mixed(long value) {
            long mixed = (value ^ value >>> HALF) * ODD;
            return (mixed ^ mixed >>> HALF - 3) * ODD ^ mixed;
        }
    }
}
