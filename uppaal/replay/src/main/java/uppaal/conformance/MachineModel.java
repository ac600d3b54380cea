package uppaal.conformance;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Predicate;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
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
        Step then(Edge edge) {
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

        boolean isOf(boolean clone) {
            return clone ? !guards.contains("!clone") : !guards.replace("!clone", "").contains("clone");
        }

        boolean isStay() {
            return from.equals(to);
        }

        @Override
        public String toString() {
            return state(from) + " -> " + state(to);
        }
    }

    private final String initial;
    private final List<Step> steps = new ArrayList<>();

    MachineModel(Template template) {
        Set<String> passed = template.locations().stream().filter(Location::urgent).map(Location::name)
                .collect(Collectors.toSet());
        template.locations().stream().map(Location::name).filter(name -> !passed.contains(name))
                .forEach(from -> walk(template, passed, new Step(from, from, Set.of(), Set.of(), false, "")));
        initial = state(template.initial());
    }

    private void walk(Template template, Set<String> passed, Step before) {
        template.edges().stream().filter(edge -> edge.source().equals(before.to)).map(before::then).forEach(step -> {
            if (passed.contains(step.to)) {
                walk(template, passed, step);
            } else {
                steps.add(step);
            }
        });
    }

    /** As hosts call it: {@code half_open} for {@code HalfOpen}. */
    private static String state(String location) {
        return location.replaceAll("(?<=[a-z])(?=[A-Z])", "_").toLowerCase(Locale.ROOT);
    }

    private Stream<Step> from(String state, boolean killed, boolean clone) {
        return steps.stream()
                .filter(step -> step.isKill == killed && step.isOf(clone) && state(step.from).equals(state));
    }

    String initial() {
        return initial;
    }

    /** Whether it is a state that a killed host finds again. */
    boolean isRecorded(String state) {
        return steps.stream().anyMatch(step -> state(step.to).equals(state))
                && from(state, true, false).allMatch(Step::isStay);
    }

    /** Where a machine may be when its host was killed, perhaps before it told of a step behind what came. */
    Set<String> killed(String state, boolean clone, Predicate<String> came) {
        Set<String> after = new HashSet<>(Set.of(state));
        from(state, true, clone).forEach(step -> after.add(state(step.to)));
        from(state, false, clone).filter(step -> step.needs.stream().allMatch(came)).map(step -> state(step.to))
                .filter(this::isRecorded).forEach(after::add);
        return after;
    }

    /** Whether a step leads to another state, behind what came; to {@code over} also before the first and the last. */
    boolean leads(String from, String to, boolean clone, Predicate<String> came) {
        return from(from, false, clone)
                .anyMatch(step -> state(step.to).equals(to) && step.needs.stream().allMatch(came))
                || to.equals("over") && (from.equals(initial) || from(from, false, clone).findAny().isEmpty());
    }

    /** What may be said in a state, behind what came. */
    Set<String> says(String state, Predicate<String> came) {
        return steps.stream().filter(step -> state(step.to).equals(state)
                && (!step.isStay() || step.needs.stream().allMatch(came)))
                .flatMap(step -> step.says.stream()).collect(Collectors.toCollection(TreeSet::new));
    }

    /** In words, where a state leads to by itself and behind what. */
    String expected(String from, boolean clone) {
        return from(from, false, clone).filter(step -> !step.isStay())
                .map(step -> "'" + state(step.to) + "'" + (step.needs.isEmpty() ? ""
                        : " behind '" + String.join("' and '", step.needs) + "'"))
                .distinct().sorted().collect(Collectors.joining(", "));
    }

    /** The steps to another state, without kills: {@code offered -> gone}. */
    Set<String> transitions() {
        return steps.stream().filter(step -> !step.isKill && !step.isStay()).map(Step::toString)
                .collect(Collectors.toCollection(TreeSet::new));
    }
}
