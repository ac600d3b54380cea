package uppaal.language;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import uppaal.ModelException;

/** The names that may be used in one place: those declared there, then those around it. */
public final class Scope implements Names {
    private final Scope around;
    private final Map<String, Symbol> symbols = new HashMap<>();

    private Scope(Scope around) {
        this.around = around;
    }

    /** The scope of the global declarations. */
    public static Scope global() {
        return new Scope(null);
    }

    /** A scope inside this one. */
    public Scope inner() {
        return new Scope(this);
    }

    /** @throws ModelException when the name is already declared in this very scope */
    public void declare(String name, Symbol symbol, String where) {
        if (symbols.putIfAbsent(name, symbol) != null) {
            throw new ModelException(where, "'" + name + "' is declared twice");
        }
    }

    /** The meaning of a name, or of an element {@code name[0]} of an array, here. */
    public Optional<Symbol> find(String name) {
        boolean here = symbols.containsKey(name.split("\\[")[0]);
        return here || around == null ? Optional.ofNullable(symbols.get(name)) : around.find(name);
    }

    @Override
    public Optional<Term> term(String name) {
        return find(name).flatMap(Scope::term);
    }

    /** The value of a name that is declared in this very scope, if it has one. */
    public Optional<Term> local(String name) {
        return Optional.ofNullable(symbols.get(name)).flatMap(Scope::term);
    }

    private static Optional<Term> term(Symbol symbol) {
        if (symbol instanceof Symbol.Number number) {
            return Optional.of(new Term.Constant(number.value()));
        }
        if (symbol instanceof Symbol.Clock clock) {
            return Optional.of(new Term.Clock(clock.slot()));
        }
        return symbol instanceof Symbol.Variable variable
                ? Optional.of(new Term.Variable(variable.slot())) : Optional.empty();
    }
}
