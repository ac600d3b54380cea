package uppaal.replay;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Predicate;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import uppaal.document.Document;
import uppaal.document.Edge;
import uppaal.document.Location;
import uppaal.document.Template;

/**
 * What a template says of a host's machine: steps from state to state. Its states are the template's ordinary
 * locations; a step is an edge between two of them, or several through urgent and committed ones.
 */
final class MachineModel {
    /** In {@code handover.xml} messages are channels, in {@code handshake.xml} variables. */
    private static final Pattern CHANNEL = Pattern.compile("(says|comes)\\[KINDS \\* move \\+ (\\w+).*");
    private static final Pattern VARIABLE = Pattern.compile("\\b(first|second|third)\\[[^=]*?\\](?= =|$| &&)");
    private static final String KILL = "dies[me]?";

    /**
     * A step.
     *
     * @param needs what must have been handed to the host
     * @param says what the host says
     * @param guards of its edges
     */
    private record Step(String from, String to, Set<String> needs, Set<String> says, boolean isKill, String guards) {
        private Step then(Edge edge) {
            Set<String> needed = new TreeSet<>(needs);
            Set<String> said = new TreeSet<>(says);
            Matcher channel = CHANNEL.matcher(edge.synchronisation());
            if (channel.matches()) {
                (channel.group(1).equals("says") ? said : needed).add(channel.group(2).toLowerCase(Locale.ROOT));
            }
            VARIABLE.matcher(edge.guard()).results().forEach(found -> needed.add(found.group(1)));
            VARIABLE.matcher(edge.assignment()).results().forEach(found -> said.add(found.group(1)));
            return new Step(from, edge.target(), needed, said, isKill || edge.synchronisation().equals(KILL),
                    guards + " " + edge.guard());
        }

        /** Whether it is one of a machine that is or is not a clone's. */
        private boolean isOf(boolean clone) {
            return clone ? !guards.contains("!clone") : !guards.replace("!clone", "").contains("clone");
        }
    }

    private final String initial;
    private final List<Step> steps = new ArrayList<>();

    MachineModel(Document model, String template) {
        Template known = model.template(template);
        Set<String> passed = known.locations().stream().filter(Location::urgent).map(Location::name)
                .collect(Collectors.toSet());
        known.locations().stream().map(Location::name).filter(name -> !passed.contains(name))
                .forEach(from -> walk(known, passed, new Step(from, from, Set.of(), Set.of(), false, "")));
        initial = state(known.initial());
    }

    private void walk(Template template, Set<String> passed, Step before) {
        for (Edge edge : template.edges()) {
            if (edge.source().equals(before.to)) {
                Step step = before.then(edge);
                if (passed.contains(edge.target())) {
                    walk(template, passed, step);
                } else {
                    steps.add(new Step(state(step.from), state(step.to), step.needs, step.says, step.isKill,
                            step.guards));
                }
            }
        }
    }

    /** As hosts call it: {@code half_open} for {@code HalfOpen}. */
    private static String state(String location) {
        return location.replaceAll("(?<=[a-z])(?=[A-Z])", "_").toLowerCase(Locale.ROOT);
    }

    String initial() {
        return initial;
    }

    /** Whether what was said once is said again unasked, of which such a model does not speak. */
    boolean repeats() {
        return steps.stream().noneMatch(step -> step.from.equals(step.to) && !step.says.isEmpty());
    }

    /** Whether it is a state that a killed host finds again. */
    boolean isRecorded(String state) {
        return steps.stream().anyMatch(step -> step.to.equals(state)) && killed(state, false).equals(Set.of(state));
    }

    /** What the shortest of the steps to another state needs of what came; nothing where none is possible. */
    Optional<Set<String>> needs(String from, String to, boolean clone, Predicate<String> came) {
        return steps.stream().filter(step -> !step.isKill && step.isOf(clone) && step.from.equals(from)
                && step.to.equals(to) && step.needs.stream().allMatch(came)).map(Step::needs)
                .min(Comparator.comparing(Set::size));
    }

    /** Where a machine may be when its host was killed. */
    Set<String> killed(String state, boolean clone) {
        Set<String> after = new HashSet<>(Set.of(state));
        steps.stream().filter(step -> step.isKill && step.isOf(clone) && step.from.equals(state))
                .forEach(step -> after.add(step.to));
        return after;
    }

    /** What is said with a step to a state from another one. */
    Set<String> saysOnce(String state) {
        return steps.stream().filter(step -> step.to.equals(state) && !step.from.equals(state))
                .flatMap(step -> step.says.stream()).collect(Collectors.toCollection(TreeSet::new));
    }

    /** What is said in a state again and again, and what the shortest step of each word needs of what came. */
    Map<String, Set<String>> says(String state, Predicate<String> came) {
        Map<String, Set<String>> words = new TreeMap<>();
        steps.stream().filter(step -> step.to.equals(state) && step.from.equals(state)
                && step.needs.stream().allMatch(came))
                .forEach(step -> step.says.forEach(word -> words.merge(word, step.needs,
                        (one, other) -> one.size() <= other.size() ? one : other)));
        return words;
    }

    /** In words, where a state leads to by itself and behind what. */
    String expected(String from, boolean clone) {
        return steps.stream().filter(step -> !step.isKill && step.isOf(clone) && step.from.equals(from)
                && !step.to.equals(from))
                .map(step -> "'" + step.to + "'" + (step.needs.isEmpty() ? ""
                        : " behind '" + String.join("' and '", step.needs) + "'"))
                .distinct().sorted().collect(Collectors.joining(", "));
    }

    /** The pairs of states between which a step leads without a kill. */
    Set<String> transitions() {
        return steps.stream().filter(step -> !step.isKill && !step.from.equals(step.to))
                .map(step -> transition(step.from, step.to)).collect(Collectors.toCollection(TreeSet::new));
    }

    static String transition(String from, String to) {
        return from + " -> " + to;
    }
}
