package uppaal.language;

import java.util.Map;
import java.util.Optional;
import java.util.function.IntBinaryOperator;

/** The operators between two operands, with C's meaning; truth is 1 or 0. A higher level binds more tightly. */
public enum Operator {
    IMPLY("imply", 0, (left, right) -> truth(left == 0 || right != 0)),
    OR("||", 0, (left, right) -> truth(left != 0 || right != 0)),
    AND("&&", 1, (left, right) -> truth(left != 0 && right != 0)),
    EQUAL("==", 2, (left, right) -> truth(left == right)),
    UNEQUAL("!=", 2, (left, right) -> truth(left != right)),
    LESS("<", 3, (left, right) -> truth(left < right)),
    AT_MOST("<=", 3, (left, right) -> truth(left <= right)),
    MORE(">", 3, (left, right) -> truth(left > right)),
    AT_LEAST(">=", 3, (left, right) -> truth(left >= right)),
    SHIFTED("<<", 4, Operator::shifted),
    PLUS("+", 5, Math::addExact),
    MINUS("-", 5, Math::subtractExact),
    TIMES("*", 6, Math::multiplyExact),
    OVER("/", 6, (left, right) -> left / right);

    /** The level that binds most tightly. */
    static final int TIGHTEST = 6;
    private static final Map<String, Operator> WORDS = Map.of("or", OR, "and", AND);

    private final String symbol;
    private final int level;
    private final IntBinaryOperator meaning;

    Operator(String symbol, int level, IntBinaryOperator meaning) {
        this.symbol = symbol;
        this.level = level;
        this.meaning = meaning;
    }

    /** @throws ArithmeticException when the result does not fit 32 bits, or there is none */
    public int apply(int left, int right) {
        return meaning.applyAsInt(left, right);
    }

    /** The symbol that UPPAAL writes. */
    public String symbol() {
        return symbol;
    }

    /** The operator of a level that a token stands for. */
    static Optional<Operator> of(Token token, int level) {
        for (Operator operator : values()) {
            if (operator.level == level && (token.is(operator.symbol) || WORDS.get(token.text()) == operator)) {
                return Optional.of(operator);
            }
        }
        return Optional.empty();
    }

    private static int shifted(int left, int right) {
        if (right < 0 || right >= Integer.SIZE - 1) {
            throw new ArithmeticException("shifted by " + right);
        }
        return Math.multiplyExact(left, 1 << right);
    }

    private static int truth(boolean condition) {
        return condition ? 1 : 0;
    }
}
