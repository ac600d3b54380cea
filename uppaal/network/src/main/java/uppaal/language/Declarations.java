package uppaal.language;

import java.util.List;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import uppaal.ModelException;

/**
 * Parses declarations: {@code const int}, {@code const bool}, {@code int}, {@code int[low,high]}, {@code bool},
 * {@code clock}, and among the global ones {@code chan}, {@code broadcast} or {@code urgent} or both; of each also
 * arrays of one dimension.
 */
public final class Declarations {
    private static final int INT_LOW = -32768;
    private static final int INT_HIGH = 32767;

    private final Tokens tokens;
    private final Scope scope;
    private final Memory memory;
    private final boolean global;

    /** Gives each declared variable its place in the state. */
    public interface Memory {
        /** @return the new slot of a variable of this name, range (both ends included) and first value */
        int allocate(String name, int low, int high, int initial);

        /** @return the new slot of a clock, which starts at 0 */
        int allocateClock(String name);
    }

    private record Range(int low, int high) {
        boolean holds(int value) {
            return low <= value && value <= high;
        }
    }

    private Declarations(Tokens tokens, Scope scope, Memory memory, boolean global) {
        this.tokens = tokens;
        this.scope = scope;
        this.memory = memory;
        this.global = global;
    }

    /** Declares into a scope what a text declares for the whole network. */
    public static void global(String text, Scope scope, Memory memory, String where) {
        new Declarations(new Tokens(text, where), scope, memory, true).all();
    }

    /** Declares into a scope what a text declares for one instance of a template. */
    public static void local(String text, Scope scope, Memory memory, String where) {
        new Declarations(new Tokens(text, where), scope, memory, false).all();
    }

    /**
     * Declares the formal parameters of a template as constants: {@code const int[low,high] a, const bool b}.
     *
     * @param arguments a value for each of them
     */
    public static void parameters(String text, int[] arguments, Scope scope, String where) {
        Tokens tokens = new Tokens(text, where);
        Declarations parser = new Declarations(tokens, scope, null, false);
        int count = 0;
        while (!tokens.atEnd()) {
            if (count > 0) {
                tokens.expect(",");
            }
            tokens.expect("const");
            Range range = parser.range();
            String name = tokens.name();
            if (count == arguments.length) {
                throw new ModelException(where, "there is no argument for the parameter '" + name + "'");
            }
            parser.constant(name, range, arguments[count++]);
        }
        if (count < arguments.length) {
            throw new ModelException(where, arguments.length + " arguments are given for " + count + " parameters");
        }
    }

    private void all() {
        while (!tokens.atEnd()) {
            one();
            tokens.expect(";");
        }
    }

    private void one() {
        if (tokens.accept("const")) {
            Range range = range();
            initialised(true, (name, value) -> constant(name, range, value));
        } else if (tokens.accept("clock")) {
            list(name -> scope.declare(name, new Symbol.Clock(memory.allocateClock(name)), tokens.where()));
        } else if (global && Stream.of("urgent", "broadcast", "chan").anyMatch(tokens.peek()::is)) {
            boolean urgent = tokens.accept("urgent");
            boolean broadcast = tokens.accept("broadcast");
            tokens.expect("chan");
            list(name -> scope.declare(name, new Symbol.Channel(name, broadcast, urgent), tokens.where()));
        } else {
            Range range = range();
            initialised(false, (name, value) -> variable(name, range, value));
        }
    }

    /** @param declare is called for a name, or for each element of an array */
    private void list(Consumer<String> declare) {
        do {
            names().forEach(declare);
        } while (tokens.accept(","));
    }

    /** @param needed whether a first value must be given; else it is 0 */
    private void initialised(boolean needed, BiConsumer<String, Integer> declare) {
        do {
            List<String> names = names();
            boolean array = names.get(0).endsWith("]");
            boolean given = needed ? expected("=") : tokens.accept("=");
            if (given && array) {
                tokens.expect("{");
            }
            for (String name : names) {
                declare.accept(name, given ? value() : 0);
                if (given && !name.equals(names.get(names.size() - 1))) {
                    tokens.expect(",");
                }
            }
            if (given && array) {
                tokens.expect("}");
            }
        } while (tokens.accept(","));
    }

    private boolean expected(String text) {
        tokens.expect(text);
        return true;
    }

    /** A name, or those of all elements of an array. */
    private List<String> names() {
        String name = tokens.name();
        if (!tokens.accept("[")) {
            return List.of(name);
        }
        int size = value();
        tokens.expect("]");
        if (size < 1) {
            throw new ModelException(tokens.where(), "'" + name + "' has " + size + " elements");
        }
        scope.declare(name, new Symbol.Array(size), tokens.where());
        return IntStream.range(0, size).mapToObj(i -> name + "[" + i + "]").toList();
    }

    private Range range() {
        if (tokens.accept("bool")) {
            return new Range(0, 1);
        }
        if (!tokens.accept("int")) {
            throw tokens.unexpected("a declaration");
        }
        if (!tokens.accept("[")) {
            return new Range(INT_LOW, INT_HIGH);
        }
        int low = value();
        tokens.expect(",");
        int high = value();
        tokens.expect("]");
        if (low > high) {
            throw new ModelException(tokens.where(), "the range [" + low + "," + high + "] is empty");
        }
        return new Range(low, high);
    }

    private int value() {
        return new Expressions(tokens, scope).constant();
    }

    private void constant(String name, Range range, int value) {
        check(name, range, value);
        scope.declare(name, new Symbol.Number(value), tokens.where());
    }

    private void variable(String name, Range range, int initial) {
        check(name, range, initial);
        scope.declare(name, new Symbol.Variable(memory.allocate(name, range.low, range.high, initial)), tokens.where());
    }

    private void check(String name, Range range, int value) {
        if (!range.holds(value)) {
            throw new ModelException(tokens.where(),
                    "'" + name + "' is " + value + ", outside its range [" + range.low + "," + range.high + "]");
        }
    }
}
