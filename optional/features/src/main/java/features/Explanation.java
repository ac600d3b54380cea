package features;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import trace.TraceReader;
import trace.why.Why;

/** The text of a failure: what it is, when, what was seen in its place, and how this run is made again. */
final class Explanation {

    /** What is counted in each run, by board and by Jason. */
    private static final Pattern OF_EACH_RUN = Pattern.compile("cycle|nb\\w+|serialRequests|radioSent|radioLateMicros");
    /** A sketch whose loop(), percepts or action takes longer is told of. */
    private static final int SLOW_MILLIS = 50;
    private static final int MOST_SEEN = 25;

    private final Run run;
    private final Account account;
    private final StringBuilder text = new StringBuilder();

    Explanation(Run run, Account account) {
        this.run = run;
        this.account = account;
    }

    /**
     * The text.
     *
     * @param seen whether what was seen matters: the feature itself is not what is wrong.
     * @param why  a question whose answer belongs to it; null for none.
     */
    String of(String what, boolean seen, Expectations.Question why) {
        text.append("  at ").append(Seen.seconds(run.nanos())).append(": ").append(what).append('\n');
        List<Seen> since = account.since().stream().filter(each -> each.kind() != Seen.Kind.PIN
                || !account.servo(each.who(), each.what()).isKnown()).toList();
        if (seen && !since.isEmpty()) {
            text.append("  seen since ").append(Seen.seconds(account.when())).append(":\n");
            since.subList(Math.max(0, since.size() - MOST_SEEN), since.size())
                    .forEach(each -> text.append("    ").append(each).append('\n'));
        }
        if (why != null) {
            answer(why);
        }
        if (run.agents() != null) {
            run.agents().agents().forEach(this::describe);
            list("  on: ", account.on());
            list("  counted: ", run.agents().agents().stream()
                    .flatMap(agent -> run.expected.counts(agent).entrySet().stream()).filter(Explanation::isTold)
                    .map(each -> each.getKey().equals(Expectations.UNANSWERED) ? each.getKey()
                            : each.getKey() + " " + Expectations.number(each.getValue()))
                    .toList());
        }
        return text.toString();
    }

    private void answer(Expectations.Question why) {
        try {
            text.append("  why:\n");
            new Why(TraceReader.all(run.log())).answer(why.what(), why.agent())
                    .forEach(line -> text.append("    ").append(line).append('\n'));
        } catch (IOException | IllegalArgumentException none) {
            text.append("    ").append(none.getMessage()).append('\n');
        }
    }

    private static boolean isTold(Map.Entry<String, Object> count) {
        return Expectations.number(count.getValue()) >= (count.getKey().endsWith("Millis") ? SLOW_MILLIS : 1)
                && !OF_EACH_RUN.matcher(count.getKey()).matches();
    }

    private void describe(String agent) {
        list("  " + agent + " believes: ", account.beliefs(agent).stream().map(Seen::brief).toList());
        if (run.lacksPercepts(agent)) {
            text.append("  ").append(agent)
                    .append(" has no percepts of its board: its plans need .percepts(open), its sketch percepts\n");
        }
        list("  " + agent + " has plans for what it has never believed: ", run.agents().planned(agent).entrySet()
                .stream().filter(each -> !account.everBelieved(agent, each.getKey().replaceFirst("/.*", "")))
                .map(each -> "+" + each.getKey() + " (" + each.getValue() + ")").toList());
    }

    private void list(String head, List<String> all) {
        if (!all.isEmpty()) {
            text.append(head).append(String.join(", ", all)).append('\n');
        }
    }
}
