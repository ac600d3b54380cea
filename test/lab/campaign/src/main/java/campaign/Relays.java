package campaign;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

import harness.Report;
import harness.Table;

/** The messages that relays deliver, and their cost: lines, pairs of relays, a field, and a cell that needs none. */
final class Relays implements Campaign {

    private static final int SEEDS = 2;
    private static final double SECONDS = 400;
    private static final double TEST_SECONDS = 30;
    private static final double BIT_ERROR_RATE = 1e-3;
    /** The step between boards on a line or a square, with a range of 100 m: each hears its neighbours only. */
    private static final double STEP_METRES = 80;
    /** The distance from a relay of a pair to either end: these do not hear each other. */
    private static final double PAIR_METRES = 60;
    /** Two relays so far apart do not hear each other. */
    private static final double HIDDEN_METRES = 110;
    private static final int HOPS = 4;
    private static final int LINES = 9;
    private static final int COPIES_OF_PAIRS = 4;
    private static final double LINE_MEAN_SECONDS = 12;
    private static final double PAIR_MEAN_SECONDS = 10;
    private static final int CELL_BOARDS = 10;
    private static final double CELL_MEAN_SECONDS = 2;
    private static final int FIELD_BOARDS = 20;
    private static final double FIELD_MEAN_SECONDS = 20;
    private static final double FIELD_METRES = 290;
    private static final double RANGE_METRES = 100;
    private static final double AIM_SHARE = 0.999;
    private static final double AIM_MEDIAN_SECONDS = 3;
    private static final double MEDIAN = 0.5;
    private static final double MOST = 0.95;

    /** One row: what the same traffic gave. */
    private record Case(String name, String simulated, TrafficRun.Plan plan) {}

    @Override
    public String name() {
        return "relay";
    }

    @Override
    public void run(Settings settings, Report report) throws Exception {
        Case line = new Case("line of " + HOPS + " hops", "100.0 %, 2.6 s, 6.8 s", line());
        Case one = new Case("one relay between two boards", "100.0 %, 1.0 s, 5.3 s", pair(1, 0));
        Case near = new Case("two that hear each other", "100.0 %, 1.0 s, 5.4 s; air −1…2 % more", pair(2, 0));
        Case hidden = new Case("two that do not", "100.0 %, 1.0 s, 5.7 s; air 3…6 % more", pair(2, HIDDEN_METRES));
        Case alone = new Case("cell of " + CELL_BOARDS + " without a relay", "100.0 %, 0.5 s, 1.7 s", cell(Set.of()));
        Case idle = new Case("the same, one of them a relay", "100.0 %, 0.5 s, 1.6 s; air 2 % more",
                cell(Set.of(CELL_BOARDS - 1)));
        Case field = new Case("field of " + FIELD_BOARDS + ", all of them relays", "97.1 %, 5.6 s, 25 s", field());
        List<Case> cases = List.of(line, one, near, hidden, alone, idle, field);
        List<List<TrafficRun.Plan>> sets = settings.small()
                ? List.of(List.of(line.plan, one.plan))
                : List.of(Collections.nCopies(LINES, line.plan), Collections.nCopies(LINES, line.plan),
                        java.util.stream.Stream.of(one, near, hidden)
                                .flatMap(pair -> Collections.nCopies(COPIES_OF_PAIRS, pair.plan).stream()).toList(),
                        List.of(alone.plan, idle.plan, field.plan));
        Map<TrafficRun.Plan, List<TrafficRun.Result>> results = TrafficRun.all(sets, settings,
                settings.choose(SEEDS, 1), settings.choose(SECONDS, TEST_SECONDS), BIT_ERROR_RATE, report);
        describe(cases, results, report);
        Traffic.Sent sent = sent(results.get(line.plan));
        report.aim(Table.text("%.1f %% delivered over %d hops", 100 * AIM_SHARE, HOPS),
                sent.sum().delivered() > 0 && sent.sum().delivered() >= AIM_SHARE * sent.sum().offered());
        report.aim(Table.text("median over %d hops at most %.0f s", HOPS, AIM_MEDIAN_SECONDS),
                sent.longestWait(MEDIAN) <= AIM_MEDIAN_SECONDS);
        Ledger.Sum all = results.values().stream().flatMap(List::stream).map(TrafficRun.Result::sum)
                .reduce(Ledger.Sum.ZERO, Ledger.Sum::plus);
        all.report(report);
        report.never("a unicast without an end", all.open());
        report.never("a nonce with two messages",
                results.values().stream().flatMap(List::stream).mapToLong(TrafficRun.Result::repeated).sum());
    }

    private static void describe(List<Case> cases, Map<TrafficRun.Plan, List<TrafficRun.Result>> results,
            Report report) {
        report.text("""
            Unicasts of %d bytes at random times (Poisson), at a bit error rate of 1e-3. Lines: %d boards %.0f m apart
            with a range of %.0f m, the first sends to the last every %.0f s. Pairs: the relays between two boards,
            every %.0f s. Cell: all boards in one range, every %.0f s from one of nine to the next. Field: %d boards in
            a square of %.0f m, %d pairs of them chosen by chance, of all together every %.0f s.
            *Wait*: emulated time from the host's message to the report that it was delivered. *Air*: all packets, for
            each message that was delivered. *Simulated*: delivered, median and 95 %% of the waits, as a simulation of
            the rules of SPEC 7.5 has them."""
                .formatted(TrafficRun.LENGTH, HOPS + 1, STEP_METRES, RANGE_METRES, LINE_MEAN_SECONDS, PAIR_MEAN_SECONDS,
                        CELL_MEAN_SECONDS, FIELD_BOARDS, FIELD_METRES, FIELD_BOARDS, FIELD_MEAN_SECONDS));
        Table table = new Table("boards", "unicasts", "delivered", "of a run", "median wait", "of a run",
                "95 % wait at most", "packets each", "air each", "simulated");
        for (Case each : cases) {
            List<TrafficRun.Result> some = results.get(each.plan);
            if (some == null) {
                continue;
            }
            Traffic.Sent sent = sent(some);
            AirUsage.Sum air = some.stream().map(TrafficRun.Result::air).reduce(AirUsage.Sum.NONE, AirUsage.Sum::plus);
            double delivered = Math.max(1, sent.sum().delivered());
            String median = Table.text("%.2f s", sent.longestWait(MEDIAN));
            String shares = spread("%.0f", some,
                    run -> 100.0 * run.sum().delivered() / Math.max(1, run.sum().offered())) + " %";
            String medians = spread("%.1f", some, run -> sent(List.of(run)).longestWait(MEDIAN)) + " s";
            if (each == cases.get(0) || each == cases.get(cases.size() - 1)) {
                report.claim(each.name + ", delivered", Table.of(sent.sum().delivered(), sent.sum().offered()), shares);
                report.claim("wait", median, medians);
            }
            table.row(each.name, sent.sum().offered(), Table.percent(sent.sum().delivered(), sent.sum().offered()),
                    shares, median, medians,
                    Table.text("%.1f s", sent.longestWait(MOST)), Table.text("%.1f", air.packets() / delivered),
                    Table.text("%.2f s", air.seconds() / delivered), each.simulated);
        }
        report.table(table);
        report.text("""
            Where both differ: in the simulation a packet with two wrong symbols is lost. Boards mend more: they
            put damaged copies of a packet together. So they need fewer attempts, and the longest waits are shorter. The
            field has few messages here; all else is near to what was simulated.
            """);
    }

    private static String spread(String format, List<TrafficRun.Result> runs, ToDoubleFunction<TrafficRun.Result> of) {
        return Table.spread(format, runs.stream().mapToDouble(of));
    }

    private static Traffic.Sent sent(List<TrafficRun.Result> runs) {
        return runs.stream().flatMap(run -> run.sent().stream()).reduce(Traffic.Sent.NONE, Traffic.Sent::plus);
    }

    private static TrafficRun.Plan line() {
        List<Map<String, Object>> boards = IntStream.rangeClosed(0, HOPS).mapToObj(hop -> at(hop * STEP_METRES, 0))
                .toList();
        Set<Integer> relays = IntStream.range(1, HOPS).boxed().collect(Collectors.toSet());
        return new TrafficRun.Plan(new Field.Cell("Station", boards, relays),
                List.of(new Traffic.Flow(0, HOPS, LINE_MEAN_SECONDS)));
    }

    /** The ends are the first two boards. */
    private static TrafficRun.Plan pair(int relays, double apart) {
        List<Map<String, Object>> boards = new ArrayList<>(List.of(at(-PAIR_METRES, 0), at(PAIR_METRES, 0)));
        for (int relay = 0; relay < relays; relay++) {
            boards.add(at(0, relays == 1 ? 0 : apart * (relay - 0.5)));
        }
        return new TrafficRun.Plan(
                new Field.Cell("Station", boards, IntStream.range(2, 2 + relays).boxed().collect(Collectors.toSet())),
                List.of(new Traffic.Flow(0, 1, PAIR_MEAN_SECONDS)));
    }

    private static TrafficRun.Plan cell(Set<Integer> relays) {
        int senders = CELL_BOARDS - 1;
        return new TrafficRun.Plan(
                new Field.Cell("Station", Collections.nCopies(CELL_BOARDS, Map.of()), relays),
                IntStream.range(0, senders)
                        .mapToObj(from -> new Traffic.Flow(from, (from + 1) % senders, senders * CELL_MEAN_SECONDS))
                        .toList());
    }

    /** Everybody reaches everybody, in at most four hops, as in the simulation. */
    private static TrafficRun.Plan field() {
        for (long seed = 1;; seed++) {
            SplittableRandom random = new SplittableRandom(seed);
            List<double[]> places = IntStream.range(0, FIELD_BOARDS)
                    .mapToObj(board -> new double[] {random.nextDouble(FIELD_METRES), random.nextDouble(FIELD_METRES)})
                    .toList();
            int hops = IntStream.range(0, FIELD_BOARDS).map(from -> farthest(places, from)).max().orElseThrow();
            if (hops == HOPS) {
                List<Traffic.Flow> flows = new ArrayList<>();
                for (int flow = 0; flow < FIELD_BOARDS; flow++) {
                    int to = (flow + 1 + random.nextInt(FIELD_BOARDS - 1)) % FIELD_BOARDS;
                    flows.add(new Traffic.Flow(flow, to, FIELD_BOARDS * FIELD_MEAN_SECONDS));
                }
                return new TrafficRun.Plan(new Field.Cell("Station",
                        places.stream().map(place -> at(place[0], place[1])).toList(),
                        IntStream.range(0, FIELD_BOARDS).boxed().collect(Collectors.toSet())), flows);
            }
        }
    }

    /** Hops to the board that is farthest from one; more than there are boards if some cannot be reached. */
    private static int farthest(List<double[]> places, int from) {
        int[] hops = new int[places.size()];
        java.util.Arrays.fill(hops, FIELD_BOARDS + 1);
        hops[from] = 0;
        for (int round = 0; round < places.size(); round++) {
            for (int one = 0; one < places.size(); one++) {
                for (int other = 0; other < places.size(); other++) {
                    double metres = Math.hypot(places.get(one)[0] - places.get(other)[0],
                            places.get(one)[1] - places.get(other)[1]);
                    if (metres <= RANGE_METRES) {
                        hops[other] = Math.min(hops[other], hops[one] + 1);
                    }
                }
            }
        }
        return IntStream.of(hops).max().orElseThrow();
    }

    private static Map<String, Object> at(double x, double y) {
        return Map.of("position", List.of(x, y));
    }
}
