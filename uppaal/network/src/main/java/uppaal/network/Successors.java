package uppaal.network;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import uppaal.ModelException;
import uppaal.language.Labels.Assignment;
import uppaal.language.Symbol;
import uppaal.network.JointMove.Part;

/**
 * UPPAAL's rules of what may happen next:
 * <ul>
 * <li>all guards of a step are asked before the first assignment of it is made;</li>
 * <li>on a binary channel one sender meets one receiver;</li>
 * <li>on a broadcast channel the sender never waits, and everyone who can hear it does;</li>
 * <li>the sender's assignments come first, then the receivers' in the order of the system line;</li>
 * <li>no step leads to where an invariant is false, and time passes only as long as all invariants stay true;</li>
 * <li>while an automaton is at a committed location, only steps that leave a committed location are possible;</li>
 * <li>while one is at a committed or an urgent location, no time passes.</li>
 * </ul>
 * Time passes in units, for all clocks at once that matter. Where each is already past all that it is compared with,
 * waiting changes nothing, and is no step: so a state from which nobody will ever move again is found as a deadlock.
 */
public final class Successors {
    private static final int ANY = -1;

    private final Network network;
    private final List<Running> clocks = new ArrayList<>();

    /** The steps of one network. */
    public Successors(Network network) {
        this.network = network;
        for (int i = 0; i < network.slots().size(); i++) {
            if (network.slots().get(i).clock()) {
                clocks.add(running(i));
            }
        }
    }

    private Running running(int clock) {
        int high = network.slots().get(clock).high();
        return network.owner(clock).map(owner -> new Running(clock, high, owner.slot(), owner.active(clock)))
                .orElse(new Running(clock, high, ANY, List.of()));
    }

    /**
     * Every step that is possible in a state, in the order of the system line and of the file.
     *
     * @throws ModelException when a step would take a variable out of its range
     */
    public List<JointMove> of(int[] state) {
        List<JointMove> moves = new ArrayList<>();
        boolean hurry = network.automata().stream().anyMatch(automaton -> automaton.committed(state));
        for (Automaton automaton : network.automata()) {
            for (Transition transition : automaton.outgoing(state)) {
                if ((transition.internal() || transition.sends()) && transition.guard().holds(state)) {
                    for (List<Part> parts : together(new Part(automaton, transition), state)) {
                        if (!hurry || parts.stream().anyMatch(part -> part.automaton().committed(state))) {
                            add(moves, parts, perform(parts, state));
                        }
                    }
                }
            }
        }
        if (!clocks.isEmpty() && network.automata().stream().noneMatch(automaton -> automaton.urgent(state))) {
            wait(state, moves);
        }
        return moves;
    }

    private void add(List<JointMove> moves, List<Part> parts, int[] target) {
        if (network.automata().stream().allMatch(automaton -> automaton.keepsInvariant(target))) {
            moves.add(new JointMove(parts, target));
        }
    }

    private void wait(int[] state, List<JointMove> moves) {
        int[] later = state.clone();
        for (Running clock : clocks) {
            later[clock.slot] += clock.runs(state) ? 1 : 0;
        }
        if (!Arrays.equals(later, state)) {
            add(moves, List.of(), later);
        }
    }

    /** A clock, and where its automaton must be for it to run: anywhere for a global one. */
    private record Running(int slot, int high, int automaton, List<Integer> locations) {
        boolean runs(int[] state) {
            return state[slot] < high && (automaton == ANY || locations.contains(state[automaton]));
        }
    }

    /** All ways in which others can join the automaton that begins a step. */
    private List<List<Part>> together(Part first, int[] state) {
        if (first.transition().internal()) {
            return List.of(List.of(first));
        }
        Symbol.Channel channel = first.transition().synchronisation().orElseThrow().channel();
        List<List<Part>> listening = new ArrayList<>();
        for (Automaton automaton : network.automata()) {
            if (automaton != first.automaton()) {
                listening.add(listening(automaton, channel, state));
            }
        }
        return channel.broadcast() ? everyone(first, listening) : oneOf(first, listening);
    }

    private static List<Part> listening(Automaton automaton, Symbol.Channel channel, int[] state) {
        return automaton.outgoing(state).stream()
                .filter(transition -> transition.receives(channel) && transition.guard().holds(state))
                .map(transition -> new Part(automaton, transition)).toList();
    }

    private static List<List<Part>> oneOf(Part sender, List<List<Part>> listening) {
        return listening.stream().flatMap(List::stream).map(receiver -> List.of(sender, receiver)).toList();
    }

    /** Each automaton that can hear takes part; where it can in several ways, each way is a step of its own. */
    private static List<List<Part>> everyone(Part sender, List<List<Part>> listening) {
        List<List<Part>> ways = List.of(List.of(sender));
        for (List<Part> choices : listening) {
            if (!choices.isEmpty()) {
                ways = ways.stream().flatMap(way -> choices.stream().map(choice -> joined(way, choice))).toList();
            }
        }
        return ways;
    }

    private static List<Part> joined(List<Part> way, Part choice) {
        List<Part> longer = new ArrayList<>(way);
        longer.add(choice);
        return longer;
    }

    private int[] perform(List<Part> parts, int[] state) {
        int[] next = state.clone();
        for (Part part : parts) {
            next[part.automaton().slot()] = part.transition().target();
            for (Assignment assignment : part.transition().assignments()) {
                assign(assignment, next, part);
            }
        }
        return next;
    }

    private void assign(Assignment assignment, int[] state, Part part) {
        Slot slot = network.slots().get(assignment.slot());
        int value = assignment.value().value(state);
        if (!slot.holds(value)) {
            throw new ModelException(network.file(), part + " would make '" + slot.name() + "' " + value
                    + ", outside its range [" + slot.low() + "," + slot.high() + "]");
        }
        state[assignment.slot()] = value;
    }
}
