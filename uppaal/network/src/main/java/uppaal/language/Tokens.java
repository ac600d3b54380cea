package uppaal.language;

import java.util.List;
import java.util.Set;
import uppaal.ModelException;

/** The tokens of one text, read from left to right. */
final class Tokens {
    /** Words of UPPAAL that are no names; those that this checker reads are asked for before a name is. */
    private static final Set<String> KEYWORDS = Set.of(
            "const", "int", "bool", "chan", "broadcast", "urgent", "clock", "typedef", "struct", "scalar", "meta",
            "double",
            "void", "string", "true", "false", "not", "and", "or", "xor", "imply", "forall", "exists", "sum",
            "deadlock",
            "system", "process", "priority", "before_update", "after_update", "progress", "gantt", "select", "if",
            "else",
            "for", "while", "do", "switch", "return", "dynamic", "import", "hybrid", "spawn", "exit", "numOf",
            "A", "E", "U", "W", "R", "M", "sup", "inf", "Pr", "control", "simulate", "strategy");

    private final List<Token> tokens;
    private final String where;
    private int position;

    Tokens(String text, String where) {
        this.tokens = Lexer.tokens(text, where);
        this.where = where;
    }

    /** File and element, for messages. */
    String where() {
        return where;
    }

    Token peek() {
        return tokens.get(position);
    }

    boolean atEnd() {
        return peek().kind() == Token.Kind.END;
    }

    Token next() {
        return atEnd() ? peek() : tokens.get(position++);
    }

    /** Takes the next token if it is this one. */
    boolean accept(String text) {
        boolean taken = peek().is(text);
        position += taken ? 1 : 0;
        return taken;
    }

    void expect(String text) {
        if (!accept(text)) {
            throw unexpected("'" + text + "'");
        }
    }

    void expectEnd() {
        if (!atEnd()) {
            throw unexpected("the end");
        }
    }

    /** Takes a name, which no keyword is. */
    String name() {
        Token token = peek();
        if (token.kind() != Token.Kind.NAME || KEYWORDS.contains(token.text())) {
            throw unexpected("a name");
        }
        return next().text();
    }

    /** The exception to throw when the next token is not what must stand here. */
    ModelException unexpected(String wanted) {
        Token token = peek();
        return KEYWORDS.contains(token.text())
                ? ModelException.outside(where, "'" + token.text() + "' here, where " + wanted + " is read,")
                : new ModelException(where, "expected " + wanted + ", not " + token.described());
    }
}
