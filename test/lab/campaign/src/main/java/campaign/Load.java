package campaign;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.function.ToDoubleFunction;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;

import harness.Report;
import harness.Table;
import javino.protocol.Airtime;

/** Many boards at rising load: in one range, out of each other's range, and with partners that are absent. */
final class Load implements Campaign {

    private static final int SEEDS = 3;
    /** The pairs of two boards alone, with each seed. */
    private static final int PAIRS = 3;
    private static final double SECONDS = 60;
    private static final double TEST_SECONDS = 8;
    private static final double BIT_RATE = 2000;
    /** A sealed content of 16 bytes and its acknowledgement: 40 and 18 bytes of payload (SPEC 6). */
    static final double EXCHANGE_SECONDS = (Airtime.bits(40) + Airtime.bits(18)) / BIT_RATE;
    private static final double QUARTER = 0.25;
    private static final double HALF = 0.5;
    private static final double HIGH = 0.75;
    private static final double FULL = 1;
    /** The distance between three in a row: with a range of 100 m, only neighbours hear each other. */
    private static final double APART_METRES = 80;
    private static final String HIDDEN = "2 hidden boards";

    /**
     * One row.
     *
     * @param load  airtime of messages and acknowledgements over time, if each were sent once.
     * @param other the difference from the library's example; empty for none.
     */
    private record Case(String boards, double load, String other, TrafficRun.Plan plan) {

        /** Boards in one range, each of which sends to the next, and the last one to the first. */
        static Case ring(int boards, double load, String other, String sketch) {
            return new Case(boards + " boards", load, other, new TrafficRun.Plan(new Field.Cell(sketch, boards),
                    IntStream.range(0, boards).mapToObj(from -> flow(from, (from + 1) % boards, boards, load))
                            .toList()));
        }

        static Case ring(int boards, double load) {
            return ring(boards, load, "", "Station");
        }

        static Case deaf(int boards, double load) {
            return ring(boards, load, ", without carrier sense", "DeafStation");
        }

        /** Two boards that do not hear each other, and one between them to which both send. */
        static Case hidden(double load) {
            List<Map<String, Object>> boards = IntStream.range(0, 3)
                    .mapToObj(place -> Map.<String, Object>of("position", List.of(0, place * APART_METRES))).toList();
            return new Case(HIDDEN, load, "", new TrafficRun.Plan(new Field.Cell("Station", boards),
                    List.of(flow(0, 1, 2, load), flow(2, 1, 2, load))));
        }

        private static Traffic.Flow flow(int from, int to, int senders, double load) {
            return new Traffic.Flow(from, to, EXCHANGE_SECONDS * senders / load);
        }

        @Override
        public String toString() {
            return Table.text("%s, %.0f %%%s", boards, 100 * load, other);
        }
    }

    /** The results of all seeds of a row. */
    private record Row(Case of, List<TrafficRun.Result> runs) {

        Ledger.Sum sum() {
            return runs.stream().map(TrafficRun.Result::sum).reduce(Ledger.Sum.ZERO, Ledger.Sum::plus);
        }

        DoubleStream delivered() {
            return runs.stream().mapToDouble(seed -> share(seed.sum()));
        }

        /** The share of the air's time that delivered messages and their acknowledgements take. */
        DoubleStream used() {
            return runs.stream().mapToDouble(seed -> seed.perSecond() * EXCHANGE_SECONDS);
        }

        double meanUsed() {
            return used().average().orElseThrow();
        }

        /** The share that each sender delivered, in all seeds. */
        List<Double> shares() {
            return IntStream.range(0, of.plan.flows().size())
                    .mapToObj(flow -> runs.stream().map(seed -> seed.sent().get(flow)).reduce(Traffic.Sent.NONE,
                            Traffic.Sent::plus).sum())
                    .filter(sum -> sum.offered() > 0).map(Row::share).toList();
        }

        double worst() {
            return shares().stream().mapToDouble(share -> share).min().orElse(0);
        }

        /** Jain's index of the senders' shares: 1 if all are equal, 1/n if one has all. */
        double fairness() {
            double total = shares().stream().mapToDouble(share -> share).sum();
            double squares = shares().stream().mapToDouble(share -> share * share).sum();
            return squares == 0 ? 0 : total * total / (shares().size() * squares);
        }

        long packets() {
            return runs.stream().mapToLong(seed -> seed.air().packets()).sum();
        }

        static double share(Ledger.Sum sum) {
            return sum.offered() == 0 ? 0 : (double) sum.delivered() / sum.offered();
        }
    }

    @Override
    public String name() {
        return "load";
    }

    @Override
    public void run(Settings settings, Report report) throws Exception {
        List<Case> cases = settings.choose(campaign(), test());
        Absent absent = new Absent(settings);
        // Plans that deliver little take long to end.
        List<TrafficRun.Plan> easy = new ArrayList<>();
        List<TrafficRun.Plan> hard = new ArrayList<>(absent.plans());
        for (Case each : cases) {
            boolean isEasy = each.other.isEmpty() && !each.boards.equals(HIDDEN);
            // Small cells several times, for more figures.
            (isEasy ? easy : hard).addAll(
                    Collections.nCopies(each.plan.boards() == 2 ? settings.choose(PAIRS, 1) : 1, each.plan));
        }
        int seeds = settings.choose(SEEDS, 1);
        double seconds = settings.choose(SECONDS, TEST_SECONDS);
        Map<TrafficRun.Plan, List<TrafficRun.Result>> results =
                TrafficRun.all(List.of(hard, easy), settings, seeds, seconds, report);
        List<Row> rows = cases.stream().map(each -> new Row(each, results.get(each.plan))).toList();
        describe(rows, seeds, seconds, report);
        if (!settings.small()) {
            aims(rows, report);
            claims(rows, report);
        }
        absent.describe(results, report);
        List<TrafficRun.Result> all = results.values().stream().flatMap(List::stream).toList();
        Ledger.Sum sum = all.stream().map(TrafficRun.Result::sum).reduce(Ledger.Sum.ZERO, Ledger.Sum::plus);
        sum.report(report);
        report.never("a unicast without an end", sum.open());
        report.never("a nonce with two messages", all.stream().mapToLong(TrafficRun.Result::repeated).sum());
    }

    private static List<Case> test() {
        return List.of(Case.ring(4, HALF), Case.deaf(4, HALF), Case.ring(2, HALF), Case.hidden(HALF));
    }

    private static List<Case> campaign() {
        List<Case> cases = new ArrayList<>();
        for (int boards : List.of(2, 5, 10, 20, 40)) {
            for (double load : boards == 40 ? List.of(HIGH, FULL) : List.of(HALF, HIGH, FULL)) {
                cases.add(Case.ring(boards, load));
            }
        }
        cases.add(Case.ring(5, QUARTER));
        cases.add(Case.deaf(5, QUARTER));
        for (double load : List.of(0.1, QUARTER, HALF, HIGH)) {
            cases.add(Case.hidden(load));
        }
        return cases;
    }

    private static void describe(List<Row> rows, int seeds, double seconds, Report report) {
        report.text("""
            All boards of a row are in one range, but for the *hidden* ones: two that do not hear each other, and a
            third one between them to which both send. Each board sends sealed contents of 16 bytes at random times
            (Poisson), to its neighbour, for %.0f s; then the run waits for all of them. *Load*: the measured share of
            the air's time that messages and acknowledgements would take if each were sent once. *Delivered*: the share
            of the offered messages that was reported delivered. A message that a full queue *refused* counts as
            offered: at full load queues grow as long as messages are offered. *Worst board*: the least share of one
            board. *Fairness*: Jain's index of the boards' shares. *Air used*: the share of the last two thirds of the
            time that delivered messages and their acknowledgements took. Figures are those of %d seeds together,
            with each of which two boards have three runs, and *of a run* those of the worst and the best one.
            *Without carrier sense* they run `test/system/sketches/DeafStation`, which begins to send even if others
            are on the air, and listens only for the answer to its own message; all else is the same."""
                .formatted(seconds, seeds));
        Table table = new Table("boards, load", "unicasts", "load", "delivered", "of a run", "refused", "worst board",
                "fairness", "packets each", "air used", "of a run");
        for (Row row : rows) {
            Ledger.Sum sum = row.sum();
            table.row(row.of, sum.offered(),
                    Table.text("%.0f %%", 100 * sum.offered() * EXCHANGE_SECONDS / (seconds * row.runs.size())),
                    Table.percent(sum.delivered(), sum.offered()), spread(row.delivered()), sum.refused(),
                    Table.text("%.1f %%", 100 * row.worst()), Table.text("%.3f", row.fairness()),
                    Table.text("%.2f", (double) row.packets() / sum.offered()),
                    Table.text("%.1f %%", 100 * row.meanUsed()), spread(row.used()));
        }
        report.table(table);
    }

    private static String spread(DoubleStream shares) {
        return Table.spread("%.1f", shares.map(share -> 100 * share)) + " %";
    }

    private static void aims(List<Row> rows, Report report) {
        report.aim("at 50 % offered load at least 90 % delivered, however many boards in one range",
                rows.stream().filter(row -> row.of.load == HALF && row.of.other.isEmpty()
                        && !row.of.boards.equals(HIDDEN)).allMatch(row -> Row.share(row.sum()) >= 0.9));
        for (double load : List.of(HIGH, FULL)) {
            aim(rows, report, Case.ring(20, load), "delivered", row -> Row.share(row.sum()), 0.99);
            aim(rows, report, Case.ring(20, load), "delivered of the worst board", Row::worst, 0.95);
            aim(rows, report, Case.ring(40, load), "delivered", row -> Row.share(row.sum()), 0.98);
        }
        aim(rows, report, Case.hidden(HALF), "delivered", row -> Row.share(row.sum()), 0.95);
        aim(rows, report, Case.hidden(HIGH), "delivered", row -> Row.share(row.sum()), 0.85);
        aim(rows, report, Case.ring(20, FULL), "of the air used", Row::meanUsed, 0.65);
    }

    private static void claims(List<Row> rows, Report report) {
        for (Case each : List.of(Case.ring(40, FULL), Case.deaf(5, QUARTER), Case.hidden(QUARTER),
                Case.hidden(HALF))) {
            Row row = find(rows, each);
            report.claim(each + ", delivered", Table.of(row.sum().delivered(), row.sum().offered()),
                    spread(row.delivered()));
        }
        Row full = find(rows, Case.ring(20, FULL));
        report.claim(full.of + ", air used", Table.text("%.1f %%", 100 * full.meanUsed()), spread(full.used()));
    }

    private static Row find(List<Row> rows, Case of) {
        return rows.stream().filter(row -> row.of.equals(of)).findFirst().orElseThrow();
    }

    private static void aim(List<Row> rows, Report report, Case of, String what, ToDoubleFunction<Row> figure,
            double least) {
        report.aim(Table.text("%s: at least %.0f %% %s", of, 100 * least, what),
                figure.applyAsDouble(find(rows, of)) >= least);
    }
}
