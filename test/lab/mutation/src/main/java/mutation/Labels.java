package mutation;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * All small changes of what stands beside the edges and locations of a model.
 *
 * @param constants the names of its numbers that never change
 */
record Labels(Set<String> constants) {

    private static final Pattern TOKEN =
            Pattern.compile("[A-Za-z_]\\w*|\\d+|<=|>=|==|!=|&&|\\|\\||\\+\\+|--|:=|[^\\s\\w]");
    private static final Map<String, List<String>> OPERATORS =
            Map.of("<", List.of("<=", "!="), "<=", List.of("<", "=="), ">", List.of(">=", "!="), ">=",
                    List.of(">", "=="), "==", List.of("<=", ">="), "!=", List.of("<", ">"), "&&", List.of("||"), "||",
                    List.of("&&"), "true", List.of("false"), "false", List.of("true"));
    /** The operators of opposite conditions. A clock's has none, since clocks are never compared by {@code <}. */
    private static final Map<String, String> OPPOSITES =
            Map.of("==", "!=", "!=", "==", "<", ">=", ">=", "<", ">", "<=", "<=", ">");
    private static final Pattern COMPARISON = Pattern.compile("([\\w.\\[\\] +*-]+?) *(==|!=|<=|>=|<|>) *"
            + "([\\w.\\[\\] +*-]+)");
    private static final Pattern STEP = Pattern.compile("([\\w.\\[\\]]+) *(\\+\\+|--)");

    /** The changes of a guard: a part negated or left out, another operator, another number. */
    List<Change> ofGuard(String guard) {
        List<Change> changes = new ArrayList<>();
        List<String> parts = parts(guard, "&&");
        for (int i = 0; i < parts.size(); i++) {
            changes.add(new Change("without '" + parts.get(i) + "'", without(parts, i, " && ")));
            String negated = negated(parts.get(i));
            changes.add(new Change("'" + negated + "' for '" + parts.get(i) + "'", with(parts, i, negated, " && ")));
        }
        changes.addAll(ofValues(guard));
        return changes;
    }

    /** The changes of an invariant: a part left out, made tighter or looser by one. */
    List<Change> ofInvariant(String invariant) {
        List<Change> changes = new ArrayList<>();
        List<String> parts = parts(invariant, "&&");
        for (int i = 0; i < parts.size(); i++) {
            changes.add(new Change("without '" + parts.get(i) + "'", without(parts, i, " && ")));
            for (String step : List.of("+", "-")) {
                String moved = parts.get(i) + " " + step + " 1";
                changes.add(new Change("'" + moved + "'", with(parts, i, moved, " && ")));
            }
        }
        return changes;
    }

    /** The changes of assignments: one left out, turned round, or given another value. */
    List<Change> ofUpdate(String update) {
        List<Change> changes = new ArrayList<>();
        List<String> parts = parts(update, ",");
        for (int i = 0; i < parts.size(); i++) {
            String part = parts.get(i);
            changes.add(new Change("without '" + part + "'", without(parts, i, ", ")));
            Matcher step = STEP.matcher(part);
            if (step.matches()) {
                String turned = step.group(1) + (step.group(2).equals("++") ? "--" : "++");
                changes.add(new Change("'" + turned + "' for '" + part + "'", with(parts, i, turned, ", ")));
                continue;
            }
            int value = part.indexOf('=') + 1;
            for (Change change : ofValues(part.substring(value))) {
                String changed = part.substring(0, value) + change.text();
                changes.add(new Change("'" + changed + "' for '" + part + "'", with(parts, i, changed, ", ")));
            }
        }
        return changes;
    }

    /**
     * The changes of a synchronisation: none, the other end of the channel, or the next channel of the same kind.
     *
     * @param kinds channels of each kind, in the order of the file
     */
    List<Change> ofSynchronisation(String synchronisation, List<List<String>> kinds) {
        List<Change> changes = new ArrayList<>();
        String text = synchronisation.strip();
        changes.add(new Change("without '" + text + "'", ""));
        String name = text.split("\\W", 2)[0];
        String behind = text.substring(name.length());
        String turned = name + (behind.endsWith("!") ? behind.replace('!', '?') : behind.replace('?', '!'));
        changes.add(new Change("'" + turned + "' for '" + text + "'", turned));
        for (List<String> kind : kinds) {
            int at = kind.indexOf(name);
            if (at >= 0 && kind.size() > 1) {
                String other = kind.get((at + 1) % kind.size()) + behind;
                changes.add(new Change("'" + other + "' for '" + text + "'", other));
            }
        }
        return changes;
    }

    /** Another operator, or a number that is greater or less by one. */
    List<Change> ofValues(String text) {
        List<Change> changes = new ArrayList<>();
        Matcher token = TOKEN.matcher(text);
        while (token.find()) {
            for (String other : others(token.group())) {
                changes.add(new Change("'" + other + "' for '" + token.group() + "' in '" + text.strip() + "'",
                        text.substring(0, token.start()) + other + text.substring(token.end())));
            }
        }
        return changes;
    }

    private List<String> others(String token) {
        if (Character.isDigit(token.charAt(0))) {
            return List.of(Integer.toString(Integer.parseInt(token) + 1),
                    Integer.toString(Integer.parseInt(token) - 1));
        }
        return constants.contains(token) ? List.of("(" + token + " + 1)", "(" + token + " - 1)")
                : OPERATORS.getOrDefault(token, List.of());
    }

    private static String negated(String condition) {
        Matcher comparison = COMPARISON.matcher(condition);
        if (comparison.matches()) {
            return comparison.group(1) + " " + OPPOSITES.get(comparison.group(2)) + " " + comparison.group(3);
        }
        if (condition.matches("!?[\\w.\\[\\]]+")) {
            return condition.startsWith("!") ? condition.substring(1) : "!" + condition;
        }
        return "!(" + condition + ")";
    }

    /** The parts between separators, but not within parentheses. */
    static List<String> parts(String text, String separator) {
        List<String> parts = new ArrayList<>();
        int depth = 0;
        int begin = 0;
        Matcher token = TOKEN.matcher(text);
        while (token.find()) {
            depth += "([{".contains(token.group()) ? 1 : ")]}".contains(token.group()) ? -1 : 0;
            if (depth == 0 && (token.group().equals("||") || token.group().equals("imply"))) {
                return List.of(text.strip());
            }
            if (depth == 0 && token.group().equals(separator)) {
                parts.add(text.substring(begin, token.start()).strip());
                begin = token.end();
            }
        }
        parts.add(text.substring(begin).strip());
        return parts;
    }

    private static String without(List<String> parts, int index, String separator) {
        List<String> left = new ArrayList<>(parts);
        left.remove(index);
        return String.join(separator, left);
    }

    private static String with(List<String> parts, int index, String part, String separator) {
        List<String> all = new ArrayList<>(parts);
        all.set(index, part);
        return String.join(separator, all);
    }
}
