package uppaal.check;

import java.util.ArrayList;
import java.util.List;
import uppaal.network.Automaton;
import uppaal.network.Network;
import uppaal.network.Slot;

/**
 * A way from the first state to another.
 *
 * @param moves the steps
 * @param last the state that they lead to
 * @param loopStart the index of the step that comes next, where it goes on there as before
 */
public record DiagnosticTrace(Network network, List<JointMove> moves, int[] last, Ending ending, int loopStart) {
    /** The way that it goes on after the last state. */
    public enum Ending {
        /** It is what was looked for. */
        REACHED,
        /** Nothing more need happen. */
        STAYS,
        /** A step of before, and all after it, for ever. */
        LOOPS
    }

    /**
     * One line a step, behind the time at which it happens, then the last state: all that is not as it was at first.
     */
    public List<String> lines() {
        List<String> lines = new ArrayList<>();
        int time = 0;
        for (JointMove move : moves) {
            if (move.passesTime()) {
                time++;
            } else {
                lines.add(String.format("%3d  %s%s", lines.size() + 1,
                        network.timed() ? String.format("%4d: ", time) : "", move));
            }
        }
        lines.add("  => " + String.join(", ", changed()));
        switch (ending) {
            case STAYS -> lines.add("  and so it may stay for ever");
            case LOOPS -> lines.add("  and so again for ever, from step " + number(loopStart) + " on");
            default -> {}
        }
        return lines;
    }

    private long number(int move) {
        return moves.stream().limit(move).filter(one -> !one.passesTime()).count() + 1;
    }

    private List<String> changed() {
        int[] first = network.initial();
        List<String> changed = new ArrayList<>();
        for (Automaton automaton : network.automata()) {
            if (last[automaton.slot()] != first[automaton.slot()]) {
                changed.add(automaton.name() + "." + automaton.locations().get(last[automaton.slot()]).name());
            }
        }
        for (int i = 0; i < first.length; i++) {
            if (last[i] != first[i] && !isLocation(i)) {
                Slot slot = network.slots().get(i);
                changed.add(slot.name() + " = " + last[i]);
            }
        }
        return changed.isEmpty() ? List.of("the first state") : changed;
    }

    private boolean isLocation(int slot) {
        return network.automata().stream().anyMatch(automaton -> automaton.slot() == slot);
    }
}
