package uppaal.language;

import java.util.Optional;
import uppaal.ModelException;

/**
 * Parses expressions: {@code ?: imply || or && and == != < <= > >= << + - * / ! not}, parentheses, numbers, {@code
 * true}, {@code false}, names and elements of arrays. UPPAAL gives {@code imply} and {@code ||} the same level,
 * readers do not; so an expression that chains {@code imply} with either, without parentheses, is refused.
 */
public final class Expressions {
    private final Tokens tokens;
    private final Names names;

    Expressions(Tokens tokens, Names names) {
        this.tokens = tokens;
        this.names = names;
    }

    /**
     * Parses a whole text.
     *
     * @param where file and element, for messages
     */
    public static Term parse(String text, Names names, String where) {
        Tokens tokens = new Tokens(text, where);
        Term term = new Expressions(tokens, names).expression();
        tokens.expectEnd();
        return term;
    }

    /** An expression. */
    Term expression() {
        Term condition = level(0);
        if (!tokens.accept("?")) {
            return condition;
        }
        Term yes = expression();
        tokens.expect(":");
        Term no = expression();
        if (condition instanceof Term.Constant constant) {
            return constant.number() == 0 ? no : yes;
        }
        return new Term.Choice(condition, yes, no);
    }

    /** An expression whose value is known before the network runs. */
    int constant() {
        Term term = expression();
        if (term instanceof Term.Constant constant) {
            return constant.number();
        }
        throw new ModelException(tokens.where(), "a constant is needed where a variable is used");
    }

    private Term level(int level) {
        if (level > Operator.TIGHTEST) {
            return unary();
        }
        Term left = level(level + 1);
        Operator before = null;
        for (Optional<Operator> found = operator(level); found.isPresent(); found = operator(level)) {
            Operator operator = found.get();
            if (before != null && (before == Operator.IMPLY || operator == Operator.IMPLY)) {
                throw new ModelException(tokens.where(), "put parentheses where 'imply' meets 'imply' or 'or'");
            }
            before = operator;
            left = binary(operator, left, level(level + 1));
        }
        return left;
    }

    private Optional<Operator> operator(int level) {
        Optional<Operator> operator = Operator.of(tokens.peek(), level);
        operator.ifPresent(found -> tokens.next());
        return operator;
    }

    private Term unary() {
        if (tokens.accept("!") || tokens.accept("not")) {
            Term operand = unary();
            return operand instanceof Term.Constant constant
                    ? new Term.Constant(constant.number() == 0 ? 1 : 0) : new Term.Not(operand);
        }
        if (tokens.accept("-")) {
            Term operand = unary();
            return operand instanceof Term.Constant constant
                    ? new Term.Constant(Math.negateExact(constant.number())) : new Term.Negative(operand);
        }
        return primary();
    }

    private Term primary() {
        if (tokens.accept("(")) {
            Term inner = expression();
            tokens.expect(")");
            return inner;
        }
        if (tokens.accept("true")) {
            return Term.TRUE;
        }
        if (tokens.accept("false")) {
            return new Term.Constant(0);
        }
        if (tokens.peek().kind() == Token.Kind.NUMBER) {
            return new Term.Constant(number(tokens.next().text()));
        }
        return named();
    }

    private int number(String digits) {
        try {
            return Integer.parseInt(digits);
        } catch (NumberFormatException tooLong) {
            throw new ModelException(tokens.where(), digits + " does not fit 32 bits");
        }
    }

    private Term named() {
        if (tokens.peek().is("deadlock")) {
            return names.term(tokens.next().text())
                    .orElseThrow(() -> new ModelException(tokens.where(), "'deadlock' has a meaning in queries only"));
        }
        String name = reference();
        boolean member = tokens.accept(".");
        String full = member ? name + "." + reference() : name;
        Optional<Term> term = member ? names.member(name, full.substring(name.length() + 1)) : names.term(name);
        return term.orElseThrow(() -> new ModelException(tokens.where(), "'" + full + "' has no value here"));
    }

    /** A name, or an element of an array as {@code name[2]}: its index is known before the network runs. */
    String reference() {
        String name = tokens.name();
        if (!tokens.accept("[")) {
            return name;
        }
        if (!(expression() instanceof Term.Constant index)) {
            throw ModelException.outside(tokens.where(), "'" + name + "[...]' with an index that is not constant");
        }
        tokens.expect("]");
        return name + "[" + index.number() + "]";
    }

    private Term binary(Operator operator, Term left, Term right) {
        if (!(left instanceof Term.Constant first && right instanceof Term.Constant second)) {
            return new Term.Binary(operator, left, right);
        }
        try {
            return new Term.Constant(operator.apply(first.number(), second.number()));
        } catch (ArithmeticException overflow) {
            throw new ModelException(tokens.where(), "a constant does not fit 32 bits, or is divided by 0");
        }
    }
}
