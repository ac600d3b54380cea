package uppaal.language;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import uppaal.ModelException;

/** Cuts UPPAAL text into tokens; comments and white space go. */
final class Lexer {
    private static final Pattern BLANK = Pattern.compile("(?:\\s|//[^\\n]*|/\\*(?s:.*?)\\*/)+");
    private static final Pattern TOKEN = Pattern.compile(
            "(?<name>[A-Za-z_][A-Za-z0-9_]*)|(?<number>[0-9]+)"
                    + "|(?<symbol><=|>=|==|!=|&&|\\|\\||\\+\\+|--|:=|\\+=|-=|<<|>>|<>|->|"
                    + "[-+*/%<>=!?:;,.&|^~'(){}\\[\\]])");

    private Lexer() {
    }

    static List<Token> tokens(String text, String where) {
        List<Token> tokens = new ArrayList<>();
        Matcher blank = BLANK.matcher(text);
        Matcher token = TOKEN.matcher(text);
        int at = 0;
        while (true) {
            at = blank.region(at, text.length()).lookingAt() ? blank.end() : at;
            if (at == text.length()) {
                tokens.add(new Token(Token.Kind.END, ""));
                return tokens;
            }
            if (text.startsWith("/*", at)) {
                throw new ModelException(where, "a comment is not closed");
            }
            if (!token.region(at, text.length()).lookingAt()) {
                throw ModelException.outside(where, "the character '" + Character.toString(text.codePointAt(at)) + "'");
            }
            tokens.add(new Token(kind(token), token.group()));
            at = token.end();
        }
    }

    private static Token.Kind kind(Matcher token) {
        if (token.group("name") != null) {
            return Token.Kind.NAME;
        }
        return token.group("number") != null ? Token.Kind.NUMBER : Token.Kind.SYMBOL;
    }
}
