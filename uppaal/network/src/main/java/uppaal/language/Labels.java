package uppaal.language;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import uppaal.ModelException;

/** Parses what stands beside an edge. */
public final class Labels {
    private Labels() {
    }

    /**
     * A parsed synchronisation.
     *
     * @param sends true for {@code !}, false for {@code ?}
     */
    public record Synchronisation(Symbol.Channel channel, boolean sends) {
    }

    /**
     * A parsed assignment.
     *
     * @param slot the variable's place in the state
     * @param value its new value
     */
    public record Assignment(int slot, Term value) {
    }

    /** @param text an expression, or nothing, which is always true */
    public static Term guard(String text, Scope scope, String where) {
        return condition(text, scope, where);
    }

    /**
     * Clocks are compared with {@code <=} only.
     *
     * @param text an expression, or nothing, which is always true
     */
    public static Term invariant(String text, Scope scope, String where) {
        Term term = condition(text, scope, where);
        for (Clocks.Bound bound : Clocks.bounds(term, where)) {
            if (bound.operator() != Operator.AT_MOST) {
                throw ModelException.outside(where, "an invariant that compares a clock by other than '<='");
            }
        }
        return term;
    }

    private static Term condition(String text, Scope scope, String where) {
        Term term = text.isBlank() ? Term.TRUE : Expressions.parse(text, scope, where);
        Clocks.bounds(term, where);
        return term;
    }

    /** @param text {@code channel!}, {@code channel?} or nothing */
    public static Optional<Synchronisation> synchronisation(String text, Scope scope, String where) {
        if (text.isBlank()) {
            return Optional.empty();
        }
        Tokens tokens = new Tokens(text, where);
        String name = new Expressions(tokens, scope).reference();
        boolean sends = tokens.accept("!");
        if (!sends) {
            tokens.expect("?");
        }
        tokens.expectEnd();
        if (scope.find(name).orElse(null) instanceof Symbol.Channel channel) {
            return Optional.of(new Synchronisation(channel, sends));
        }
        throw new ModelException(where, "'" + name + "' is no channel");
    }

    /** @param text assignments between commas, performed from left to right: {@code x = e}, {@code x++}, {@code x--} */
    public static List<Assignment> assignments(String text, Scope scope, String where) {
        List<Assignment> assignments = new ArrayList<>();
        Tokens tokens = new Tokens(text, where);
        if (tokens.atEnd()) {
            return assignments;
        }
        do {
            assignments.add(assignment(tokens, scope));
        } while (tokens.accept(","));
        tokens.expectEnd();
        return assignments;
    }

    private static Assignment assignment(Tokens tokens, Scope scope) {
        String name = new Expressions(tokens, scope).reference();
        if (scope.find(name).orElse(null) instanceof Symbol.Clock clock) {
            return reset(tokens, clock);
        }
        if (!(scope.find(name).orElse(null) instanceof Symbol.Variable variable)) {
            throw new ModelException(tokens.where(), "'" + name + "' is no variable");
        }
        Term now = new Term.Variable(variable.slot());
        Term one = new Term.Constant(1);
        if (tokens.accept("++")) {
            return new Assignment(variable.slot(), new Term.Binary(Operator.PLUS, now, one));
        }
        if (tokens.accept("--")) {
            return new Assignment(variable.slot(), new Term.Binary(Operator.MINUS, now, one));
        }
        expectAssignment(tokens);
        Term value = new Expressions(tokens, scope).expression();
        if (Clocks.isIn(value)) {
            throw ModelException.outside(tokens.where(), "a clock whose time is stored");
        }
        return new Assignment(variable.slot(), value);
    }

    private static Assignment reset(Tokens tokens, Symbol.Clock clock) {
        expectAssignment(tokens);
        if (!tokens.accept("0")) {
            throw ModelException.outside(tokens.where(), "a clock that is set to other than 0");
        }
        return new Assignment(clock.slot(), new Term.Constant(0));
    }

    private static void expectAssignment(Tokens tokens) {
        if (!tokens.accept("=")) {
            tokens.expect(":=");
        }
    }
}
