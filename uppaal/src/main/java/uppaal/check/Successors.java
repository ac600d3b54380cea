package uppaal.check;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.BiConsumer;
import java.util.stream.IntStream;
import uppaal.ModelException;
import uppaal.check.JointMove.Part;
import uppaal.language.Labels.Assignment;
import uppaal.language.Symbol;
import uppaal.language.Term;
import uppaal.network.Automaton;
import uppaal.network.Network;
import uppaal.network.Slot;
import uppaal.network.Transition;

/**
 * UPPAAL's rules of what may happen next:
 * <ul>
 * <li>all guards of a step are asked before the first assignment of it is made;</li>
 * <li>on a binary channel one sender meets one receiver;</li>
 * <li>on a broadcast channel the sender never waits, and everyone who can hear it does;</li>
 * <li>the sender's assignments come first, then the receivers' in the order of the system line;</li>
 * <li>no step leads to where an invariant is false, and time passes only as long as all invariants stay true;</li>
 * <li>while an automaton is at a committed location, only steps that leave a committed location are possible;</li>
 * <li>while one is at a committed or an urgent location, or a step on an urgent channel is possible, no time
 * passes.</li>
 * </ul>
 * Time passes in units, for all clocks at once that matter. If each is already past all that it is compared with,
 * waiting changes nothing, and is no step: so a state from which nobody will ever move again is found as a deadlock.
 */
public final class Successors {
    private static final int ANY = -1;

    private final Network network;
    private final List<Automaton> automata;
    /** By automaton: which of its clocks matter at each location, and what leaves that. */
    private final Map<Automaton, List<Set<Integer>>> active = new IdentityHashMap<>();
    private final Map<Automaton, List<List<Transition>>> leaving = new IdentityHashMap<>();
    private final List<Running> clocks = new ArrayList<>();
    /** The steps that an automaton can begin, by automaton and location. */
    private final Start[][][] starts;
    /** The invariants, by automaton and location. */
    private final Term[][] invariants;
    private final Slot[] slots;

    /** The steps of one network. */
    public Successors(Network network) {
        this.network = network;
        this.automata = network.automata();
        this.slots = network.slots().toArray(Slot[]::new);
        automata.forEach(this::analyse);
        this.starts = automata.stream().map(this::starts).toArray(Start[][][]::new);
        this.invariants = automata.stream().map(automaton -> automaton.invariants().toArray(Term[]::new))
                .toArray(Term[][]::new);
        for (int i = 0; i < slots.length; i++) {
            if (slots[i].clock()) {
                clocks.add(running(i));
            }
        }
    }

    private void analyse(Automaton automaton) {
        ActiveClocks analysis = new ActiveClocks(automaton.invariants(), automaton.transitions());
        List<Set<Integer>> clocks = analysis.byLocation();
        List<Transition> resetting = analysis.resetting(automaton.clocks(), clocks);
        active.put(automaton, clocks);
        leaving.put(automaton, IntStream.range(0, clocks.size()).mapToObj(location -> resetting.stream()
                .filter(transition -> transition.source() == location).toList()).toList());
    }

    /** A global clock always runs. */
    private Running running(int clock) {
        int high = slots[clock].high();
        return automata.stream().filter(automaton -> automaton.clocks().contains(clock)).findFirst()
                .map(owner -> new Running(clock, high, owner.slot(), IntStream.range(0, owner.locations().size())
                        .filter(location -> active.get(owner).get(location).contains(clock)).boxed().toList()))
                .orElse(new Running(clock, high, ANY, List.of()));
    }

    /** A clock, and where its automaton must be for it to run: anywhere for a global one. */
    private record Running(int slot, int high, int automaton, List<Integer> locations) {
        boolean runs(int[] state) {
            return state[slot] < high && (automaton == ANY || locations.contains(state[automaton]));
        }
    }

    /**
     * A step that an automaton begins alone or as a sender.
     *
     * @param alone its own part
     * @param others none where it moves alone
     */
    private record Start(List<Part> alone, boolean broadcast, List<Listener> others) {
        Part part() {
            return alone.get(0);
        }
    }

    /** Another automaton, and by its location in which ways it may receive. */
    private record Listener(int slot, Part[][] ways) {
        Part[] at(int[] state) {
            return ways[state[slot]];
        }
    }

    private Start[][] starts(Automaton automaton) {
        return leaving.get(automaton).stream().map(each -> each.stream()
                .filter(transition -> transition.internal() || transition.sends())
                .map(transition -> start(automaton, transition)).toArray(Start[]::new)).toArray(Start[][]::new);
    }

    private Start start(Automaton automaton, Transition transition) {
        List<Part> alone = List.of(new Part(automaton, transition));
        if (transition.internal()) {
            return new Start(alone, false, List.of());
        }
        Symbol.Channel channel = transition.synchronisation().orElseThrow().channel();
        return new Start(alone, channel.broadcast(), automata.stream().filter(other -> other != automaton)
                .map(other -> new Listener(other.slot(), ways(other, channel))).toList());
    }

    private Part[][] ways(Automaton automaton, Symbol.Channel channel) {
        return leaving.get(automaton).stream().map(each -> each.stream()
                .filter(transition -> transition.receives(channel)).map(transition -> new Part(automaton, transition))
                .toArray(Part[]::new)).toArray(Part[][]::new);
    }

    /**
     * Every step that is possible in a state, in the order of the system line and of the file.
     *
     * @throws ModelException when a step would take a variable out of its range
     */
    public List<JointMove> of(int[] state) {
        List<JointMove> moves = new ArrayList<>();
        each(state, (parts, target) -> moves.add(new JointMove(parts, target)));
        return moves;
    }

    /**
     * As {@link #of(int[])}, for who counts steps in millions.
     *
     * @return whether the network may stay in the state for ever: time passes there, and changes nothing
     */
    public boolean each(int[] state, BiConsumer<List<Part>, int[]> found) {
        boolean[] urgent = {urgent(state)};
        moves(state, (parts, target) -> {
            urgent[0] |= parts.get(0).transition().urgent();
            found.accept(parts, target);
        });
        if (urgent[0]) {
            return false;
        }
        int[] later = later(state);
        if (Arrays.equals(later, state)) {
            return true;
        }
        if (keepsInvariants(later)) {
            found.accept(List.of(), later);
        }
        return false;
    }

    /** All steps but that of time. */
    private void moves(int[] state, BiConsumer<List<Part>, int[]> found) {
        boolean hurry = committed(state);
        for (int i = 0; i < starts.length; i++) {
            for (Start start : starts[i][state[automata.get(i).slot()]]) {
                if (start.part().transition().guard().holds(state)) {
                    together(start, state, hurry, found);
                }
            }
        }
    }

    private boolean committed(int[] state) {
        for (Automaton automaton : automata) {
            if (automaton.at(state).committed()) {
                return true;
            }
        }
        return false;
    }

    private boolean urgent(int[] state) {
        for (Automaton automaton : automata) {
            if (automaton.at(state).urgent()) {
                return true;
            }
        }
        return false;
    }

    private boolean keepsInvariants(int[] state) {
        for (int i = 0; i < invariants.length; i++) {
            if (!invariants[i][state[automata.get(i).slot()]].holds(state)) {
                return false;
            }
        }
        return true;
    }

    private int[] later(int[] state) {
        int[] later = state.clone();
        for (Running clock : clocks) {
            later[clock.slot] += clock.runs(state) ? 1 : 0;
        }
        return later;
    }

    /** All ways in which others can join the automaton that begins a step. */
    private void together(Start start, int[] state, boolean hurry, BiConsumer<List<Part>, int[]> found) {
        if (start.part().transition().internal()) {
            perform(start.alone, state, hurry, found);
        } else if (start.broadcast) {
            everyone(start.alone, start.others, 0, state, hurry, found);
        } else {
            for (Listener other : start.others) {
                for (Part part : other.at(state)) {
                    if (part.transition().guard().holds(state)) {
                        perform(List.of(start.part(), part), state, hurry, found);
                    }
                }
            }
        }
    }

    /**
     * Each automaton that can hear takes part; where it can in several ways, each way is a step of its own.
     *
     * @param heard those that take part already
     * @param next the first of the others that has not been asked
     */
    private void everyone(List<Part> heard, List<Listener> others, int next, int[] state, boolean hurry,
            BiConsumer<List<Part>, int[]> found) {
        if (next == others.size()) {
            perform(heard, state, hurry, found);
            return;
        }
        boolean deaf = true;
        for (Part part : others.get(next).at(state)) {
            if (part.transition().guard().holds(state)) {
                deaf = false;
                List<Part> longer = new ArrayList<>(heard);
                longer.add(part);
                everyone(longer, others, next + 1, state, hurry, found);
            }
        }
        if (deaf) {
            everyone(heard, others, next + 1, state, hurry, found);
        }
    }

    private void perform(List<Part> parts, int[] state, boolean hurry, BiConsumer<List<Part>, int[]> found) {
        if (hurry && parts.stream().noneMatch(part -> part.automaton().at(state).committed())) {
            return;
        }
        int[] target = state.clone();
        for (Part part : parts) {
            target[part.automaton().slot()] = part.transition().target();
            for (Assignment assignment : part.transition().assignments()) {
                assign(assignment, target, part);
            }
        }
        if (keepsInvariants(target)) {
            found.accept(parts, target);
        }
    }

    private void assign(Assignment assignment, int[] state, Part part) {
        Slot slot = slots[assignment.slot()];
        int value = assignment.value().value(state);
        if (!slot.holds(value)) {
            throw new ModelException(network.file(), part + " would make '" + slot.name() + "' " + value
                    + ", outside its range [" + slot.low() + "," + slot.high() + "]");
        }
        state[assignment.slot()] = value;
    }
}
