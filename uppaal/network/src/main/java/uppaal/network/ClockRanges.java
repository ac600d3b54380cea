package uppaal.network;

import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import uppaal.ModelException;
import uppaal.language.Clocks;
import uppaal.language.Operator;
import uppaal.language.Term;

/**
 * Finds how far each clock need be counted: one past the largest number that any guard or invariant compares it with.
 * No condition tells what lies beyond apart.
 */
final class ClockRanges {
    private final List<Slot> slots;
    private final String file;

    ClockRanges(List<Slot> slots, String file) {
        this.slots = slots;
        this.file = file;
    }

    /** The slots, with the ranges that the clocks need in these automata. */
    List<Slot> of(List<Automaton> automata) {
        List<Clocks.Bound> bounds = automata.stream().flatMap(automaton -> conditions(automaton))
                .flatMap(condition -> Clocks.bounds(condition, file).stream()).toList();
        return IntStream.range(0, slots.size()).mapToObj(i -> ranged(i, bounds)).toList();
    }

    private static Stream<Term> conditions(Automaton automaton) {
        return Stream.concat(automaton.transitions().stream().map(Transition::guard), automaton.invariants().stream());
    }

    private Slot ranged(int index, List<Clocks.Bound> bounds) {
        Slot slot = slots.get(index);
        return slot.clock() ? Slot.clock(slot.name(), bounds.stream().filter(bound -> bound.slot() == index)
                .mapToInt(bound -> greatest(bound.limit())).max().orElse(0)) : slot;
    }

    /** The greatest value that a term can have: of numbers, variables and their sums. */
    private int greatest(Term term) {
        if (term instanceof Term.Constant constant) {
            return constant.number();
        } else if (term instanceof Term.Variable variable) {
            return slots.get(variable.slot()).high();
        } else if (term instanceof Term.Binary binary && binary.operator() == Operator.PLUS) {
            return Math.addExact(greatest(binary.left()), greatest(binary.right()));
        }
        if (term instanceof Term.Choice choice) {
            return Math.max(greatest(choice.yes()), greatest(choice.no()));
        }
        throw ModelException.outside(file, "a clock that is compared with other than a sum of numbers and variables");
    }
}
