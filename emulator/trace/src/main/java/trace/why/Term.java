package trace.why;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BiPredicate;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;

/**
 * A belief, goal or event of AgentSpeak as far as answers need it: {@code +!go(home,_)[source(self)]}.
 *
 * @param sign        {@code +}, {@code -} or empty.
 * @param goal        {@code !}, {@code ?} or empty.
 * @param functor     its name, with {@code ~} where it is negated.
 * @param arguments   as they are written.
 * @param annotations as they are written.
 */
record Term(String sign, String goal, String functor, List<String> arguments, List<String> annotations) {

    private static final Pattern HEAD = Pattern.compile("([+-]*)([!?]*)(~?\\.?\\w[\\w.:]*)");
    private static final Pattern VARIABLE = Pattern.compile("_\\w*|\\p{Lu}\\w*");
    private static final Pattern EXPRESSION = Pattern.compile("(?<!\\w)[_\\p{Lu}]");

    /** Reads a text; what stands behind the term does not matter. Nothing if it is none. */
    static Optional<Term> parse(String as) {
        String text = as.strip().replaceAll("\\b_\\d+\\b", "_");
        Matcher head = HEAD.matcher(text);
        if (!head.lookingAt()) {
            return Optional.empty();
        }
        String rest = text.substring(head.end());
        int end = rest.startsWith("(") ? end(rest) : 0;
        String behind = rest.substring(end);
        int last = behind.startsWith("[") ? end(behind) : 0;
        return Optional.of(new Term(head.group(1).isEmpty() ? "" : head.group(1).substring(0, 1), head.group(2),
                head.group(3), parts(rest, end), parts(behind, last)));
    }

    /** Behind the bracket that closes the first one; the end where none does. */
    private static int end(String text) {
        int depth = 0;
        boolean quoted = false;
        for (int i = 0; i < text.length(); i++) {
            char character = text.charAt(i);
            quoted ^= character == '"' && (i == 0 || text.charAt(i - 1) != '\\');
            depth += quoted ? 0 : "([{".indexOf(character) >= 0 ? 1 : ")]}".indexOf(character) >= 0 ? -1 : 0;
            if (depth == 0) {
                return i + 1;
            }
        }
        return text.length();
    }

    /** Whether each bracket outside of quotes has its other one. */
    static boolean isClosed(String text) {
        return end("(" + text + ") ") == text.length() + 2;
    }

    private static List<String> parts(String text, int end) {
        List<String> parts = new ArrayList<>();
        int from = 1;
        int at = 1;
        while (at < end) {
            char character = text.charAt(at);
            if (character == ',' || at == end - 1) {
                parts.add(text.substring(from, at).strip());
                from = at + 1;
            }
            at += "([{\"".indexOf(character) >= 0 ? Math.max(1, quotedOrNested(text, at)) : 1;
        }
        return end == 0 ? List.of() : parts;
    }

    private static int quotedOrNested(String text, int at) {
        return text.charAt(at) == '"' ? text.indexOf('"', at + 1) - at + 1 : end(text.substring(at));
    }

    /** Whether that has the same name and number of arguments. */
    boolean isOfKind(Term other) {
        return functor.equals(other.functor) && arguments.size() == other.arguments.size();
    }

    /** Whether that is an instance of this, whose variables match anything; annotations do not matter. */
    boolean matches(Term other) {
        return matches(other, Term::matches);
    }

    private boolean matches(Term other, BiPredicate<String, String> argument) {
        return isOfKind(other) && IntStream.range(0, arguments.size())
                .allMatch(i -> argument.test(arguments.get(i), other.arguments.get(i)));
    }

    private static boolean matches(String pattern, String text) {
        if (VARIABLE.matcher(pattern).matches() || VARIABLE.matcher(text).matches() || pattern.equals(text)) {
            return true;
        }
        Optional<Term> one = parse(pattern);
        return one.isPresent() && !one.get().arguments.isEmpty()
                && parse(text).filter(other -> one.get().matches(other)).isPresent();
    }

    /** Whether a step of a plan may be an instance of this, by the values that its variables have. */
    boolean mayBe(Term step) {
        return matches(step, (mine, its) -> EXPRESSION.matcher(its).find() || matches(mine, its));
    }

    /** Whether it is an action of Jason's, not of a board. */
    boolean isInternal() {
        return functor.contains(".");
    }

    /** What a message says that an agent's term may be: a tell of it, or an achieve of a goal. */
    boolean isSaidBy(String content) {
        int behind = content.indexOf(';');
        boolean achieves = content.startsWith("achieve");
        return behind >= 0 && achieves == goal.equals("!")
                && parse(content.substring(content.lastIndexOf(';') + 1)).filter(this::matches).isPresent();
    }

    /** The value of {@code source(S)}; empty if there is none. */
    String source() {
        return annotations.stream().filter(each -> each.startsWith("source("))
                .map(each -> each.substring("source(".length(), each.length() - 1)).findFirst().orElse("");
    }

    /** Without sign and annotations. */
    String term() {
        return goal + functor + (arguments.isEmpty() ? "" : "(" + String.join(",", arguments) + ")");
    }

    /** Without its source, which is told in other words. */
    String brief() {
        return sign + term();
    }

    /** How far apart two names are: letters that differ, are left out, added, or have changed places. */
    int distance(Term other) {
        int[][] rows = new int[functor.length() + 1][other.functor.length() + 1];
        for (int i = 0; i < rows.length; i++) {
            for (int j = 0; j < rows[0].length; j++) {
                rows[i][j] = i == 0 || j == 0 ? i + j : distance(rows, other.functor, i, j);
            }
        }
        return rows[functor.length()][other.functor.length()];
    }

    private int distance(int[][] rows, String other, int i, int j) {
        boolean same = functor.charAt(i - 1) == other.charAt(j - 1);
        int least = Math.min(rows[i - 1][j - 1] + (same ? 0 : 1), 1 + Math.min(rows[i - 1][j], rows[i][j - 1]));
        boolean swapped = i > 1 && j > 1 && functor.charAt(i - 1) == other.charAt(j - 2)
                && functor.charAt(i - 2) == other.charAt(j - 1);
        return swapped ? Math.min(least, rows[i - 2][j - 2] + 1) : least;
    }
}
