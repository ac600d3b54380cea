package javino.cli;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javino.Printable;
import javino.protocol.Content;
import javino.protocol.Performative;

/**
 * Whether a text can be the term of a content (SPEC 3). The command has no Jason, so this is no parser: it finds what
 * is no AgentSpeak by its words and brackets alone, and lets through what a parser may still refuse.
 */
final class TermText {

    private static final Pattern TOKEN =
            Pattern.compile("\\s*(?:(?<text>\"(?:[^\"\\\\]|\\\\.)*\"|'(?:[^'\\\\]|\\\\.)*')"
                    + "|(?<word>\\.?\\p{L}[\\p{L}\\p{N}_]*(?:\\.\\p{L}[\\p{L}\\p{N}_]*)*|_[\\p{L}\\p{N}_]*"
                    + "|\\p{N}+(?:\\.\\p{N}+)?(?:[eE][+-]?\\p{N}+)?)"
                    + "|(?<open>[(\\[{])|(?<close>[)\\]}])|(?<comma>,)|(?<sign>[-+*/<>=!?:;|&^~@\\\\.]))");
    private static final Pattern OPERATOR = Pattern.compile("div|mod|not|if|else|elif|while|for");
    private static final Pattern LITERAL =
            Pattern.compile("~?\\s*(?:\\p{Ll}|'|\\[|[\\p{L}_][\\p{L}\\p{N}_]*::)(?s:.*)");
    private static final Pattern END = Pattern.compile("\\s*");

    private TermText() {
    }

    /** The mistake in a content's term, in a user's words; nothing if it can be AgentSpeak. */
    static Optional<String> mistake(Content content) {
        String term = content.term().strip();
        boolean needsLiteral = !isAnswer(content) && !content.performative().toString().endsWith("How");
        if (needsLiteral && !LITERAL.matcher(term).matches()) {
            return Optional.of("a literal begins with a small letter, such as help or speed(3), not "
                    + Printable.of(term));
        }
        return mistake(term);
    }

    private static boolean isAnswer(Content content) {
        return content.isAnswer() || content.performative() == Performative.SORRY;
    }

    private static Optional<String> mistake(String term) {
        Deque<String> open = new ArrayDeque<>();
        Matcher token = TOKEN.matcher(term);
        String last = "";
        boolean afterValue = false;
        int at = 0;
        for (; token.region(at, term.length()).lookingAt(); at = token.end()) {
            String word = token.group().strip();
            boolean isValue = token.group("text") != null
                    || token.group("word") != null && !OPERATOR.matcher(word).matches();
            boolean closes = token.group("close") != null;
            if (isValue && afterValue) {
                return Optional.of("two terms with nothing between them: " + Printable.of(last + " " + word));
            }
            if (token.group("comma") != null && open.isEmpty()) {
                return Optional.of("a message has one term, and a comma ends it: write a list, [a, b]");
            }
            if (word.equals(".") && !open.contains("{")) {
                return Optional.of("a message has no full stop");
            }
            if (last.equals(",") && (closes || token.group("comma") != null)
                    || last.matches("[(\\[{]") && token.group("comma") != null || last.equals("(") && closes) {
                return Optional.of("a term is missing between " + last + " and " + word);
            }
            if (token.group("open") != null) {
                open.push(word);
            } else if (closes && (open.isEmpty() || "([{".indexOf(open.pop()) != ")]}".indexOf(word))) {
                return Optional.of("there is a " + word + " too much");
            }
            afterValue = isValue;
            last = word;
        }
        if (!END.matcher(term).region(at, term.length()).matches()) {
            String rest = term.substring(at).strip();
            return Optional.of("\"'".indexOf(rest.charAt(0)) >= 0 ? "a quotation mark is missing: " + Printable.of(rest)
                    : "it cannot go on with " + Printable.of(rest));
        }
        if (!open.isEmpty()) {
            return Optional.of("there is no end of " + open.peek());
        }
        return last.matches("[,+*/<>=:&|!?^@\\\\-]") ? Optional.of("a term is missing after " + last)
                : Optional.empty();
    }
}
