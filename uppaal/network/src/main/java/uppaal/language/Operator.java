package uppaal.language;

import java.util.Map;
import java.util.Optional;

/** The operators between two operands, with C's meaning; truth is 1 or 0. A higher level binds more tightly. */
public enum Operator {
    IMPLY("imply", 0) {
        @Override
        public int apply(int left, int right) {
            return truth(left == 0 || right != 0);
        }
    },
    OR("||", 0) {
        @Override
        public int apply(int left, int right) {
            return truth(left != 0 || right != 0);
        }
    },
    AND("&&", 1) {
        @Override
        public int apply(int left, int right) {
            return truth(left != 0 && right != 0);
        }
    },
    EQUAL("==", 2) {
        @Override
        public int apply(int left, int right) {
            return truth(left == right);
        }
    },
    UNEQUAL("!=", 2) {
        @Override
        public int apply(int left, int right) {
            return truth(left != right);
        }
    },
    LESS("<", 3) {
        @Override
        public int apply(int left, int right) {
            return truth(left < right);
        }
    },
    AT_MOST("<=", 3) {
        @Override
        public int apply(int left, int right) {
            return truth(left <= right);
        }
    },
    MORE(">", 3) {
        @Override
        public int apply(int left, int right) {
            return truth(left > right);
        }
    },
    AT_LEAST(">=", 3) {
        @Override
        public int apply(int left, int right) {
            return truth(left >= right);
        }
    },
    SHIFTED("<<", 4) {
        @Override
        public int apply(int left, int right) {
            if (right < 0 || right >= Integer.SIZE - 1) {
                throw new ArithmeticException("shifted by " + right);
            }
            return Math.multiplyExact(left, 1 << right);
        }
    },
    PLUS("+", 5) {
        @Override
        public int apply(int left, int right) {
            return Math.addExact(left, right);
        }
    },
    MINUS("-", 5) {
        @Override
        public int apply(int left, int right) {
            return Math.subtractExact(left, right);
        }
    },
    TIMES("*", 6) {
        @Override
        public int apply(int left, int right) {
            return Math.multiplyExact(left, right);
        }
    },
    OVER("/", 6) {
        @Override
        public int apply(int left, int right) {
            return left / right;
        }
    };

    /** The level that binds most tightly. */
    static final int TIGHTEST = 6;
    private static final Map<String, Operator> WORDS = Map.of("or", OR, "and", AND);

    private final String symbol;
    private final int level;

    Operator(String symbol, int level) {
        this.symbol = symbol;
        this.level = level;
    }

    /** @throws ArithmeticException when the result does not fit 32 bits, or there is none */
    public abstract int apply(int left, int right);

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

    private static int truth(boolean condition) {
        return condition ? 1 : 0;
    }
}
