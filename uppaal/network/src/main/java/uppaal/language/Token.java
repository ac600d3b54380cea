package uppaal.language;

/**
 * A piece of UPPAAL text.
 *
 * @param text as it stands; empty at the end
 */
record Token(Kind kind, String text) {
    enum Kind { NAME, NUMBER, SYMBOL, END }

    boolean is(String expected) {
        return text.equals(expected) && kind != Kind.END;
    }

    /** How messages call it. */
    String described() {
        return kind == Kind.END ? "the end" : "'" + text + "'";
    }
}
