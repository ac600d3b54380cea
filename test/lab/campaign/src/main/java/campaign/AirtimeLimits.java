package campaign;

import harness.Emulator;
import harness.Report;
import harness.Table;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;

/** Boards whose radios may send for a share of each hour, at full load: deliveries, and each board's airtime. */
final class AirtimeLimits implements Campaign {

    private static final int BOARDS = 20;
    private static final int TEST_BOARDS = 3;
    private static final double SECONDS = 3600;
    private static final double TEST_SECONDS = 90;
    private static final double MEDIAN = 0.5;
    private static final String SKETCH = "LimitedStation";
    /** What the sketch is built for, by its limit. */
    private static final Map<String, String> BUILT = Map.of("1 %", "mega", "10 %", "tenpercent");

    @Override
    public String name() {
        return "airtime";
    }

    @Override
    public void run(Settings settings, Report report) throws Exception {
        int boards = settings.choose(BOARDS, TEST_BOARDS);
        double seconds = settings.choose(SECONDS, TEST_SECONDS);
        List<String> limits = settings.choose(List.of("1 %", "10 %"), List.of("10 %"));
        List<TrafficRun> runs = limits.stream().map(limit -> new TrafficRun(settings.seed(), seconds, Map.of(),
                List.of(new TrafficRun.Plan(new Field.Cell(SKETCH, Collections.nCopies(boards, Map.of("firmware",
                        Emulator.firmware(SKETCH, BUILT.get(limit)).toString()))),
                        IntStream.range(0, boards).mapToObj(from -> new Traffic.Flow(from, (from + 1) % boards,
                                Load.EXCHANGE_SECONDS * boards)).toList()))))
                .toList();
        List<List<TrafficRun.Result>> results = Runs.all(runs, report);
        report.text(
                """
            %d boards in one range, each of which sends contents of %d bytes at random times (Poisson) to the next one
            for %.0f s, so that messages and acknowledgements would take all of the time if each were sent once. The
            boards begin with a power-up, with nothing to spend. *Refused*: the queue was full, and the host was told.
            *Most of a
            board*: the share of that time in which it sent. The replay refuses a run with an hour above the limit."""
                        .formatted(boards, TrafficRun.LENGTH, seconds));
        Table table = new Table("limit", "unicasts", "delivered", "refused", "undelivered", "median wait",
                "most of a board");
        Ledger.Sum all = Ledger.Sum.ZERO;
        for (int i = 0; i < runs.size(); i++) {
            TrafficRun.Result result = results.get(i).get(0);
            Traffic.Sent sent = result.sent().stream().reduce(Traffic.Sent.NONE, Traffic.Sent::plus);
            Ledger.Sum sum = result.sum();
            String most = Table.text("%.2f %%", 100 * result.busiest() / seconds);
            table.row(limits.get(i), sum.offered(), Table.percent(sum.delivered(), sum.offered()), sum.refused(),
                    sum.undelivered(), Table.text("%.1f s", sent.longestWait(MEDIAN)), most);
            report.claim("limit " + limits.get(i) + ", taken by the boards and delivered",
                    Table.of(sum.delivered(), sum.offered() - sum.refused()), "most of a board " + most);
            all = all.plus(sum);
        }
        report.table(table);
        all.report(report);
        report.never("a unicast without an end", all.open());
    }
}
