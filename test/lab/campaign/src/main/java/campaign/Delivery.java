package campaign;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.stream.DoubleStream;

import harness.Report;
import harness.Table;

/** Unicasts over one hop: at rising bit error rates, in bursts, and in noise. */
final class Delivery implements Campaign {

    private static final int SHORT = 16;
    private static final int LONG = 200;
    /** The seeds of the campaign, each with all cases. */
    private static final int SEEDS = 3;
    private static final List<Integer> LENGTHS = List.of(SHORT, LONG);
    private static final Field.Cell BOARDS = new Field.Cell("Station", 2);

    /**
     * One kind of air.
     *
     * @param radio   the scenario's settings of the radio.
     * @param seconds emulated, how long new messages begin.
     */
    private record Case(String name, Map<String, Object> radio, int seconds) {

        Case(double rate, int seconds) {
            this(Table.text("%.0e", rate), Map.of("bitErrorRate", rate), seconds);
        }
    }

    private static final Case CLEAN = new Case(0, 30);
    private static final Case AT_1E_3 = new Case(1e-3, 60);
    private static final Case AT_1E_2 = new Case(1e-2, 100);
    private static final Case AT_3E_2 = new Case(3e-2, 100);
    private static final Case BURSTS =
            new Case("bursts, 1e-02", Map.of("bursts", Map.of("rate", 1e-2, "length", 30, "rateWithin", 0.25)), 80);
    private static final Case NOISE = new Case("noise", Map.of("noise", Map.of()), 30);
    private static final List<Case> CAMPAIGN = List.of(CLEAN, new Case(1e-4, 30), AT_1E_3, new Case(3e-3, 60), AT_1E_2,
            AT_3E_2, BURSTS, NOISE);
    private static final List<Case> TEST = List.of(new Case(1e-2, 10),
            new Case("bursts, 1e-02", Map.of("bursts", Map.of("rate", 1e-2)), 5));

    @Override
    public String name() {
        return "delivery";
    }

    @Override
    public void run(Settings settings, Report report) throws Exception {
        int seeds = settings.choose(SEEDS, 1);
        report.text("""
            The boards (`Station`) are in pairs, each out of the others' range. One board of a pair sends unicasts to
            the other, with two always waiting. The first column tells the air, in the words of
            [emulator/README.md](../../emulator/README.md#air): the probability with which each bit that a receiver gets
            is inverted; or errors in *bursts* of 30 bits, of which 0.25 are wrong, with this mean of all bits; or clean
            air where receivers give *noise* as long as nobody sends. *Delivered* counts reports to the sender's
            host, *received* messages handed to the other host. *Packets* and *air* count everything that both boards
            send for a message: attempts, fragments and acknowledgements; a millisecond of air is two bits. Figures are
            those of %d seeds together, and *of a seed* those of the worst and the best of them."""
                .formatted(seeds));
        Table table = new Table("air, content", "unicasts", "delivered", "of a seed", "received", "packets each",
                "air per delivered byte", "of a seed");
        Rows rows = new Rows(settings.choose(CAMPAIGN, TEST), settings, seeds, report);
        rows.write(table);
        report.table(table);
        if (!settings.small()) {
            aims(rows, report);
        }
        rows.all.sum().report(report);
        report.never("a unicast without an end", rows.all.sum().open());
        report.never("a nonce with two messages", rows.all.repeated());
    }

    private static void aims(Rows rows, Report report) {
        rows.aim(report, CLEAN, SHORT, 0.999, 27.1);
        rows.aim(report, CLEAN, LONG, 0.999, 9.6);
        rows.aim(report, AT_1E_3, SHORT, 0.999, Double.POSITIVE_INFINITY);
        rows.aim(report, AT_1E_2, SHORT, 0.999, 34);
        rows.aim(report, AT_1E_2, LONG, 0.99, 13);
        for (Case each : List.of(AT_3E_2, BURSTS)) {
            rows.aim(report, each, SHORT, 0.99, Double.POSITIVE_INFINITY);
            rows.aim(report, each, LONG, 0.99, Double.POSITIVE_INFINITY);
        }
        rows.claim(report, AT_1E_2, SHORT);
        for (Case each : List.of(AT_3E_2, BURSTS)) {
            LENGTHS.forEach(length -> rows.claim(report, each, length));
        }
    }

    /** All that was measured: for each case and length, what each seed gave. */
    private static final class Rows {

        private record Row(Case of, int length, List<PairRun.Result> seeds) {

            PairRun.Result sum() {
                return Rows.sum(seeds);
            }

            /** The spread of the shares that the seeds delivered. */
            String spread() {
                return Table.spread("%.2f", seeds.stream().mapToDouble(each -> 100 * each.delivered())) + " %";
            }
        }

        private final Settings settings;
        private final List<Row> rows = new ArrayList<>();
        private final PairRun.Result all;

        Rows(List<Case> cases, Settings settings, int seeds, Report report) throws Exception {
            this.settings = settings;
            List<PairRun> runs = new ArrayList<>();
            for (Case each : cases) {
                List<PairRun.Plan> plans = new ArrayList<>();
                for (int length : LENGTHS) {
                    plans.addAll(Collections.nCopies(pairs(length), new PairRun.Plan(BOARDS, length)));
                }
                for (int seed = 0; seed < seeds; seed++) {
                    runs.add(new PairRun(each.radio, settings.seed() + seed, each.seconds, plans));
                }
            }
            List<List<PairRun.Result>> results = Runs.all(runs, report);
            for (int i = 0; i < cases.size(); i++) {
                int first = 0;
                for (int length : LENGTHS) {
                    int from = first;
                    first += pairs(length);
                    rows.add(new Row(cases.get(i), length, results.subList(i * seeds, (i + 1) * seeds).stream()
                            .map(ofPairs -> sum(ofPairs.subList(from, from + pairs(length)))).toList()));
                }
            }
            all = sum(rows.stream().map(Row::sum).toList());
        }

        /** How many pairs send contents of a length at a time. */
        private int pairs(int length) {
            return length == SHORT ? settings.choose(9, 2) : settings.choose(3, 1);
        }

        private static PairRun.Result sum(List<PairRun.Result> results) {
            return results.stream().reduce(PairRun.Result.NONE, PairRun.Result::plus);
        }

        void write(Table table) {
            for (Row row : rows) {
                PairRun.Result all = row.sum();
                Ledger.Sum sum = all.sum();
                table.row(row.of.name + ", " + row.length + " bytes", sum.offered(),
                        Table.percent(sum.delivered(), sum.offered()),
                        row.spread(),
                        Table.percent(sum.received(), sum.offered()),
                        Table.text("%.2f", (double) all.air().packets() / sum.offered()),
                        milliseconds(DoubleStream.of(all.milliseconds(row.length))),
                        milliseconds(row.seeds.stream().mapToDouble(each -> each.milliseconds(row.length))));
            }
        }

        private static String milliseconds(DoubleStream each) {
            double[] some = each.filter(Double::isFinite).toArray();
            return some.length == 0 ? "-" : Table.spread("%.1f", DoubleStream.of(some)) + " ms";
        }

        private Row find(Case of, int length) {
            return rows.stream().filter(row -> row.of == of && row.length == length).findFirst().orElseThrow();
        }

        void claim(Report report, Case of, int length) {
            Row row = find(of, length);
            report.claim(of.name + ", " + length + " bytes, delivered", Table.of(row.sum().sum().delivered(),
                    row.sum().sum().offered()), row.spread());
        }

        /** @param milliseconds the time on the air for each delivered byte, at most. */
        void aim(Report report, Case of, int length, double share, double milliseconds) {
            PairRun.Result result = find(of, length).sum();
            String air =
                    Double.isFinite(milliseconds) ? Table.text(", with at most %.1f ms of air a byte", milliseconds)
                            : "";
            report.aim(Table.text("%s: at least %.1f %% of unicasts of %d bytes%s", of.name, 100 * share, length, air),
                    result.delivered() >= share && result.milliseconds(length) <= milliseconds);
        }
    }
}
