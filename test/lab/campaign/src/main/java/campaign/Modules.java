package campaign;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;

import harness.Report;
import harness.Table;
import javino.protocol.Airtime;

/** Boards with serial modules, beside the same ones with the ASK pair: losses, load and throughput. */
final class Modules implements Campaign {

    private static final int SHORT = 16;
    private static final int LONG = 200;
    private static final int PAIRS = 2;
    private static final int SECONDS = 60;
    private static final int TEST_SECONDS = 15;
    private static final int BOARDS = 10;
    private static final double LOAD = 0.5;
    private static final double MOST_WAITS = 3;
    /** The quiet slots of an exchange: 6 and the mean of the least window before the message, one before its answer. */
    private static final double QUIET_SLOTS = 6 + 15 / 2.0 + 1;
    private static final double ASK_SLOT_MILLIS = 8;
    private static final List<Double> LOSSES = List.of(0.0, 0.1, 0.3);
    /** The payloads of a sealed content of 16 bytes, and of its acknowledgement. */
    private static final int MESSAGE = 40;
    private static final int ACKNOWLEDGEMENT = 18;

    /**
     * The kind of radio that the boards have.
     *
     * @param radio           the scenario's settings of the radio.
     * @param exchangeSeconds a message of 16 bytes and its acknowledgement on the air, and the quiet slots before them
     *                        (SPEC 6, 6.2, 7.4).
     */
    private record Kind(String name, Map<String, Object> radio, double exchangeSeconds) {

        static Kind ask() {
            return new Kind("ASK pair", Map.of(),
                    (Airtime.millis(MESSAGE) + Airtime.millis(ACKNOWLEDGEMENT) + QUIET_SLOTS * ASK_SLOT_MILLIS)
                            / 1000.0);
        }

        static Kind module(String name, double millis, double millisAByte, double slotMillis) {
            return new Kind(name, Map.of("module", name),
                    (2 * millis + millisAByte * (MESSAGE + ACKNOWLEDGEMENT + 2 * 6) + QUIET_SLOTS * slotMillis) / 1000);
        }

        /** The radio with so many packets lost; of the ASK pair, so many of 40 bytes. */
        Map<String, Object> losing(double share) {
            Map<String, Object> all = new HashMap<>(radio);
            if (share > 0 && radio.isEmpty()) {
                all.put("bitErrorRate", 1 - Math.pow(1 - share, 1.0 / Airtime.bits(MESSAGE)));
            } else {
                all.put("loss", share);
            }
            return all;
        }
    }

    @Override
    public String name() {
        return "modules";
    }

    @Override
    public void run(Settings settings, Report report) throws Exception {
        List<Kind> kinds = List.of(Kind.ask(), Kind.module("hc-12", 35, 1.04, 35), Kind.module("e32", 65, 5.42, 170));
        Ledger.Sum sum = pairs(kinds, settings, report).plus(load(kinds, settings, report));
        sum.report(report);
        report.never("a unicast without an end", sum.open());
    }

    /** Pairs, as of the campaign delivery; what was sent in all. */
    private static Ledger.Sum pairs(List<Kind> kinds, Settings settings, Report report) throws Exception {
        int seconds = settings.choose(SECONDS, TEST_SECONDS);
        List<Double> losses = settings.choose(LOSSES, List.of(0.1));
        PairRun.Plan one = new PairRun.Plan(new Field.Cell("Station", 2), SHORT);
        PairRun.Plan other = new PairRun.Plan(new Field.Cell("Station", 2), LONG);
        List<PairRun.Plan> plans = new ArrayList<>();
        for (int pair = 0; pair < settings.choose(PAIRS, 1); pair++) {
            plans.add(one);
            plans.add(other);
        }
        List<PairRun> runs = kinds.stream()
                .flatMap(kind -> losses.stream()
                        .map(loss -> new PairRun(kind.losing(loss), settings.seed(), seconds, plans)))
                .toList();
        List<List<PairRun.Result>> results = Runs.all(runs, report);
        report.text("""
            Pairs of `Station`, each out of the others' range; one board of a pair sends unicasts to the other for %d s,
            with two always waiting. *Lost*: of each piece that a module sends at once, an HC-12's of 16 bytes; for the
            ASK pair bit errors by which so many packets of 40 bytes come damaged, most of which boards mend.
            *Throughput*: delivered bytes a second."""
                .formatted(seconds));
        Table table = new Table("radio, lost, content", "unicasts", "delivered", "packets each", "throughput");
        Ledger.Sum all = Ledger.Sum.ZERO;
        for (int run = 0; run < runs.size(); run++) {
            Kind kind = kinds.get(run / losses.size());
            double loss = losses.get(run % losses.size());
            for (int length : List.of(SHORT, LONG)) {
                List<PairRun.Result> some = new ArrayList<>();
                for (int plan = length == SHORT ? 0 : 1; plan < plans.size(); plan += 2) {
                    some.add(results.get(run).get(plan));
                }
                PairRun.Result result = some.stream().reduce(PairRun.Result.NONE, PairRun.Result::plus);
                all = all.plus(result.sum());
                String name = Table.text("%s, %.0f %%, %d bytes", kind.name, 100 * loss, length);
                String speed = Table.text("%.1f bytes/s",
                        (double) length * result.sum().delivered() / some.size() / seconds);
                table.row(name, result.sum().offered(),
                        Table.percent(result.sum().delivered(), result.sum().offered()),
                        Table.text("%.2f", (double) result.air().packets() / result.sum().offered()), speed);
                if (loss == 0) {
                    report.claim(name + ", throughput", speed,
                            Table.of(result.sum().delivered(), result.sum().offered()));
                } else if (length == SHORT) {
                    report.claim(name + ", delivered", Table.of(result.sum().delivered(), result.sum().offered()),
                            speed);
                }
            }
        }
        report.table(table);
        return all;
    }

    /** Ten boards in one range at half the load that their radio can take, as of the campaign load. */
    private static Ledger.Sum load(List<Kind> kinds, Settings settings, Report report) throws Exception {
        int seconds = settings.choose(SECONDS, TEST_SECONDS);
        int boards = settings.choose(BOARDS, 3);
        Table table = new Table("radio", "unicasts", "delivered", "refused", "median wait", "packets each");
        Ledger.Sum all = Ledger.Sum.ZERO;
        List<Double> waits = new ArrayList<>();
        List<TrafficRun> runs = kinds.stream()
                .map(kind -> new TrafficRun(settings.seed(), seconds, kind.radio, List.of(new TrafficRun.Plan(
                        new Field.Cell("Station", boards),
                        IntStream.range(0, boards).mapToObj(from -> new Traffic.Flow(from, (from + 1) % boards,
                                kind.exchangeSeconds * boards / LOAD)).toList()))))
                .toList();
        List<List<TrafficRun.Result>> results = Runs.all(runs, report);
        for (int i = 0; i < kinds.size(); i++) {
            TrafficRun.Result result = results.get(i).get(0);
            Traffic.Sent sent = result.sent().stream().reduce(Traffic.Sent.NONE, Traffic.Sent::plus);
            String delivered = Table.of(sent.sum().delivered(), sent.sum().offered());
            String wait = Table.text("%.2f s", sent.longestWait(LOAD));
            table.row(kinds.get(i).name, sent.sum().offered(),
                    Table.percent(sent.sum().delivered(), sent.sum().offered()), sent.sum().refused(), wait,
                    Table.text("%.2f", (double) result.air().packets() / sent.sum().offered()));
            report.claim(Table.text("%s, %d boards at 50 %%, delivered", kinds.get(i).name, boards), delivered, wait);
            waits.add(sent.longestWait(LOAD));
            all = all.plus(result.sum());
        }
        if (!settings.small()) {
            report.aim("ten boards at 50 % of an hc-12 wait at most three times as long as with ASK pairs",
                    waits.get(1) <= MOST_WAITS * waits.get(0));
        }
        report.text("""
            %d boards in one range, each of which sends contents of %d bytes at random times (Poisson) to the next one
            for %d s, so that messages, acknowledgements and the quiet slots before them (SPEC 7.4) would take half of
            the time if each were sent once."""
                .formatted(boards, SHORT, seconds));
        report.table(table);
        return all;
    }
}
