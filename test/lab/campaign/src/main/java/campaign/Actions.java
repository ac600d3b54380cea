package campaign;

import harness.DamagedLink;
import harness.Emulator;
import harness.Host;
import harness.Report;
import harness.Table;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.concurrent.ExecutionException;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import javino.board.OutcomeUnknownException;
import javino.board.SessionCounter;

/** Actions that return a number, over a line that damages their requests and replies. */
final class Actions implements Campaign {

    private static final double DAMAGED = 1e-3;
    private static final int COUNT = 10_000;
    private static final int TEST_COUNT = 200;
    /** The sketch's own count of what came. */
    private static final Pattern PERCEPT = Pattern.compile("(performed|repeated|last)\\((\\d+)\\)");

    private int right;
    private int wrong;
    private int unknown;
    private int failed;

    @Override
    public String name() {
        return "actions";
    }

    @Override
    public void run(Settings settings, Report report) throws Exception {
        int count = settings.choose(COUNT, TEST_COUNT);
        Emulator.Scenario scenario = new Emulator.Scenario().seed(settings.seed()).discardEvents().inEmulatedTime();
        List<Field.Cell> cells = List.of(new Field.Cell("Counter", List.of(Map.of("resetOnOpen", false))));
        try (Closing closing = new Closing()) {
            Field field = closing.add(Field.start(scenario, cells, report));
            Field.Post post = field.cell(0).get(0);
            long repeats;
            long damaged;
            try (Host host = Host.atUsualTimes(DamagedLink.opener(field.link(post), settings.seed(), DAMAGED))) {
                host.board.percepts(true);
                for (int number = 1; number <= count; number++) {
                    act(host, number, report);
                }
                repeats = host.board.counters().get(SessionCounter.REPEATS);
                damaged = host.board.counters().get(SessionCounter.DAMAGED_PACKETS);
            }
            describe(count, repeats, damaged, counts(field, post), report);
        }
    }

    private void act(Host host, int number, Report report) {
        try {
            if (Host.await(host.board.act("note(" + number + ")")).equals(OptionalInt.of(~number))) {
                right++;
            } else {
                wrong++;
            }
        } catch (ExecutionException e) {
            if (e.getCause() instanceof OutcomeUnknownException) {
                unknown++;
            } else {
                failed++;
                report.progress("action %d: %s", number, e.getCause());
            }
        }
    }

    /** Asks the board over a good line. */
    private static Map<String, Integer> counts(Field field, Field.Post post) throws InterruptedException {
        try (Host host = Host.over(field.link(post))) {
            host.board.percepts(true);
            return host.percepts(all -> all.size() == 3).stream().map(PERCEPT::matcher).filter(Matcher::matches)
                    .collect(Collectors.toMap(each -> each.group(1), each -> Integer.valueOf(each.group(2)),
                            (one, other) -> other, LinkedHashMap::new));
        }
    }

    private void describe(int count, long repeats, long damaged, Map<String, Integer> counts, Report report) {
        report.text("""
            A Mega (`Counter`) performs %d actions, one after the other, each of which returns a number of its own. Of
            the bytes between host and board one in a thousand is lost, changed or preceded by another, both ways, while
            readings come too.""".formatted(count));
        report.table(new Table("actions", "right number", "outcome unknown", "performed", "requests repeated",
                "packets damaged at the host").row(count, right, unknown, counts.get("performed"), repeats, damaged));
        report.claim("1e-03 of bytes damaged, right number", Table.of(right, count), repeats + " requests repeated");
        report.claim("outcome unknown", "" + unknown, "");
        report.never("an action that was performed twice", counts.get("repeated"));
        report.never("a wrong number", wrong);
        report.never("an action that failed otherwise", failed);
        report.never("an action that succeeded and was not performed",
                Math.max(0, right + wrong - counts.get("performed")));
        report.never("an action performed that nobody asked for", Math.max(0, counts.get("performed") - count));
    }
}
