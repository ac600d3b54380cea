package uppaal.conformance;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import uppaal.document.Edge;
import uppaal.document.Template;

/**
 * A host's machine as a template has it. Its states are the template's ordinary locations; a step is an edge between
 * two of them, or several through urgent and committed ones.
 */
final class MachineModel {
    private static final String KILL = "dies[me]?";

    /**
     * A step, or an edge, from state to state.
     *
     * @param needs what must have been handed to the host
     * @param says what the host says
     */
    private record Step(String from, String to, Set<String> needs, Set<String> says) {
        static Step of(Edge edge) {
            return new Step(state(edge.source()), state(edge.target()),
                    words("comes", edge.synchronisation() + edge.guard()),
                    words("says", edge.synchronisation() + edge.assignment()));
        }

        /** In {@code handover.xml} messages are channels, in {@code handshake.xml} variables. */
        private static Set<String> words(String channel, String labels) {
            return Pattern.compile(channel + "\\[KINDS \\* move \\+ (\\w+)|\\b(first|second|third)\\[").matcher(labels)
                    .results().map(found -> found.group(found.group(1) == null ? 2 : 1).toLowerCase(Locale.ROOT))
                    .collect(Collectors.toSet());
        }

        Step then(Step next) {
            return new Step(from, next.to,
                    Stream.concat(needs.stream(), next.needs.stream()).collect(Collectors.toSet()),
                    Stream.concat(says.stream(), next.says.stream()).collect(Collectors.toSet()));
        }

        boolean isStay() {
            return from.equals(to);
        }

        boolean isBehind(Predicate<String> came) {
            return needs.stream().allMatch(came);
        }
    }

    final String initial;
    /** The states that a killed host finds again. */
    final Set<String> recorded = new HashSet<>();
    private final List<Step> steps = new ArrayList<>();

    MachineModel(Template template) {
        initial = state(template.initial());
        Set<String> passed = new HashSet<>();
        template.locations().forEach(each -> (each.urgent() ? passed : recorded).add(state(each.name())));
        Map<Boolean, List<Step>> edges = template.edges().stream().collect(Collectors.partitioningBy(
                edge -> edge.synchronisation().equals(KILL), Collectors.mapping(Step::of, Collectors.toList())));
        edges.get(true).stream().filter(kill -> !kill.isStay()).forEach(kill -> recorded.remove(kill.from));
        edges.get(true).stream().filter(Step::isStay).forEach(kill -> recorded.add(kill.from)); // but for a clone
        edges.get(false).stream().filter(edge -> !passed.contains(edge.from))
                .forEach(edge -> walk(edge, edges.get(false), passed));
    }

    private void walk(Step step, List<Step> edges, Set<String> passed) {
        if (passed.contains(step.to)) {
            edges.stream().filter(edge -> edge.from.equals(step.to))
                    .forEach(edge -> walk(step.then(edge), edges, passed));
        } else {
            steps.add(step);
        }
    }

    /** As hosts call it: {@code half_open} for {@code HalfOpen}. */
    private static String state(String location) {
        return location.replaceAll("(?<=[a-z])(?=[A-Z])", "_").toLowerCase(Locale.ROOT);
    }

    private Stream<Step> from(String state) {
        return steps.stream().filter(step -> step.from.equals(state));
    }

    /** The states to which a step leads, behind what came; {@code over} also before the first and behind the last. */
    Set<String> next(String state, Predicate<String> came) {
        boolean mayEnd = state.equals(initial) || from(state).findAny().isEmpty();
        return Stream.concat(from(state).filter(step -> step.isBehind(came)).map(Step::to),
                Stream.of("over").filter(end -> mayEnd)).collect(Collectors.toSet());
    }

    /** The messages that may be sent in a state, behind what came. */
    Stream<String> says(String state, Predicate<String> came) {
        return steps.stream().filter(step -> step.to.equals(state) && (!step.isStay() || step.isBehind(came)))
                .flatMap(step -> step.says.stream());
    }

    /** Whether it is this machine that says a word, and not the other side's. */
    boolean says(String word) {
        return steps.stream().anyMatch(step -> step.says.contains(word));
    }

    /** In words, where a machine in a state may be next, and behind what. */
    String expected(String state) {
        return "'" + state + "', or from there " + from(state).filter(step -> !step.isStay())
                .map(step -> "'" + step.to + "'"
                        + (step.needs.isEmpty() ? "" : " behind '" + String.join("' and '", step.needs) + "'"))
                .distinct().sorted().collect(Collectors.joining(", "));
    }

    /** The steps to another state: {@code offered -> gone}. */
    Stream<String> transitions() {
        return steps.stream().filter(step -> !step.isStay()).map(step -> step.from + " -> " + step.to);
    }
}
