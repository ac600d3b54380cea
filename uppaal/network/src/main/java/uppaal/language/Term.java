package uppaal.language;

import java.util.List;

/** An expression whose names have been resolved to places in a state. Truth is any number but 0. */
public sealed interface Term {
    /** Always true: the guard of an edge without a guard. */
    Term TRUE = new Constant(1);

    /** @param state the value of each slot */
    int value(int[] state);

    /** Whether it is true in a state. */
    default boolean holds(int[] state) {
        return value(state) != 0;
    }

    /** The terms that it is made of. */
    default List<Term> operands() {
        return List.of();
    }

    /** A number, a named constant or a parameter. */
    record Constant(int number) implements Term {
        @Override
        public int value(int[] state) {
            return number;
        }
    }

    /** The value that a slot holds. */
    record Variable(int slot) implements Term {
        @Override
        public int value(int[] state) {
            return state[slot];
        }
    }

    /** The time that a clock shows. */
    record Clock(int slot) implements Term {
        @Override
        public int value(int[] state) {
            return state[slot];
        }
    }

    /** Whether the automaton whose location a slot holds is at one location. */
    record At(int slot, int location) implements Term {
        @Override
        public int value(int[] state) {
            return state[slot] == location ? 1 : 0;
        }
    }

    /** {@code !operand} */
    record Not(Term operand) implements Term {
        @Override
        public int value(int[] state) {
            return operand.value(state) == 0 ? 1 : 0;
        }

        @Override
        public List<Term> operands() {
            return List.of(operand);
        }
    }

    /** {@code -operand} */
    record Negative(Term operand) implements Term {
        @Override
        public int value(int[] state) {
            return Math.negateExact(operand.value(state));
        }

        @Override
        public List<Term> operands() {
            return List.of(operand);
        }
    }

    /** {@code condition ? yes : no}; only one of the two is evaluated. */
    record Choice(Term condition, Term yes, Term no) implements Term {
        @Override
        public int value(int[] state) {
            return condition.holds(state) ? yes.value(state) : no.value(state);
        }

        @Override
        public List<Term> operands() {
            return List.of(condition, yes, no);
        }
    }

    /** {@code left operator right}; both sides are always evaluated, since no term has an effect. */
    record Binary(Operator operator, Term left, Term right) implements Term {
        @Override
        public int value(int[] state) {
            return operator.apply(left.value(state), right.value(state));
        }

        @Override
        public List<Term> operands() {
            return List.of(left, right);
        }
    }
}
