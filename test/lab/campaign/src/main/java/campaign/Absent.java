package campaign;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

import harness.Report;
import harness.Table;

/** How long messages to one partner wait while others, to which the same board sends, are absent. */
final class Absent {

    private static final double PRESENT_SECONDS = 2;
    private static final double ABSENT_SECONDS = 10;
    /** How long a message to a partner that is there may wait beside so many that are not. */
    private static final Map<Integer, Double> AIM_SECONDS = Map.of(1, 3.0, 3, 5.0, 6, 8.0);
    private static final double MOST = 0.99;

    private final Map<Integer, TrafficRun.Plan> plans = new LinkedHashMap<>();

    Absent(Settings settings) {
        for (int absent : settings.choose(List.of(0, 1, 3, 6), List.of(1))) {
            plans.put(absent, plan(absent));
        }
    }

    /** A pair; the first board sends to the second one and to absent ones. */
    private static TrafficRun.Plan plan(int absent) {
        List<Traffic.Flow> flows = new ArrayList<>();
        flows.add(new Traffic.Flow(0, 1, PRESENT_SECONDS));
        for (int i = 0; i < absent; i++) {
            flows.add(new Traffic.Flow(0, 2 + i, ABSENT_SECONDS * absent));
        }
        return new TrafficRun.Plan(new Field.Cell("Station", 2), flows);
    }

    /** Each twice, for more figures. */
    List<TrafficRun.Plan> plans() {
        List<TrafficRun.Plan> twice = new ArrayList<>(plans.values());
        twice.addAll(plans.values());
        return twice;
    }

    void describe(Map<TrafficRun.Plan, List<TrafficRun.Result>> results, Report report) {
        report.text("""
            **Absent partners.** A board sends to a partner that is there every %.0f s on average, and every %.0f s to
            one that is not: to always the same, or to one of several. *Waits*: emulated time from the host's message to
            the report that the present partner has it. Boards have messages to four partners under way
            (`JAVINO_PARTNERS`)."""
                .formatted(PRESENT_SECONDS, ABSENT_SECONDS));
        Table table =
                new Table("absent", "unicasts", "delivered", "median wait", "99 % wait at most", "longest");
        plans.forEach((absent, plan) -> {
            Traffic.Sent sent = present(results.get(plan));
            table.row(absent, sent.sum().offered(), Table.percent(sent.sum().delivered(), sent.sum().offered()),
                    wait(sent, 0.5), wait(sent, MOST), wait(sent, 1));
            if (absent != 0) {
                report.aim(Table.text("%d absent: all messages to another delivered, 99 %% within %.0f s", absent,
                        AIM_SECONDS.get(absent)),
                        sent.sum().delivered() == sent.sum().offered()
                                && sent.longestWait(MOST) <= AIM_SECONDS.get(absent));
            }
        });
        report.table(table);
        Traffic.Sent beside = present(results.get(plans.get(1)));
        report.claim("1 absent partner, wait of messages to another", wait(beside, 0.5),
                "99 %: " + wait(beside, MOST));
    }

    private static String wait(Traffic.Sent sent, double share) {
        return Table.text("%.2f s", sent.longestWait(share));
    }

    private static Traffic.Sent present(List<TrafficRun.Result> seeds) {
        return seeds.stream().map(seed -> seed.sent().get(0)).reduce(Traffic.Sent.NONE, Traffic.Sent::plus);
    }
}
