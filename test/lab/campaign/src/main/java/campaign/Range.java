package campaign;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;

import harness.Report;
import harness.Table;

/** How far unicasts reach with the emulator's path loss. */
final class Range implements Campaign {

    private static final int LENGTH = 16;
    private static final int SEEDS = 3;
    private static final int SECONDS = 100;
    private static final double AIM_SHARE = 0.99;
    private static final List<Integer> CAMPAIGN = IntStream.iterate(95, metres -> metres <= 150, metres -> metres + 5)
            .boxed().toList();
    private static final List<Integer> TEST = List.of(90, 100);
    /** A radio without shadowing, which makes a pair's every distance larger or smaller by the same factor. */
    private static final Map<String, Object> RADIO =
            Map.of("errorsByDistance", "outdoors", "range", 200, "shadowing", 0);

    /** The results at each distance, of each seed. */
    private record Reach(Map<Integer, List<PairRun.Result>> ofDistance) {

        PairRun.Result sum(int metres) {
            return ofDistance.get(metres).stream().reduce(PairRun.Result.NONE, PairRun.Result::plus);
        }

        /** The largest distance up to which enough was delivered; 0 if there is none. */
        int metres() {
            return ofDistance.keySet().stream().takeWhile(metres -> sum(metres).delivered() >= AIM_SHARE)
                    .reduce(0, (nearer, farther) -> farther);
        }

        Reach ofSeed(int seed) {
            Map<Integer, List<PairRun.Result>> some = new LinkedHashMap<>();
            ofDistance.forEach((metres, results) -> some.put(metres, List.of(results.get(seed))));
            return new Reach(some);
        }
    }

    @Override
    public String name() {
        return "range";
    }

    @Override
    public void run(Settings settings, Report report) throws Exception {
        int seeds = settings.choose(SEEDS, 1);
        List<Integer> distances = settings.choose(CAMPAIGN, TEST);
        report.text("""
            Pairs of boards as in [delivery](delivery.md), with the path loss `"outdoors"` of
            [emulator/README.md](../../emulator/README.md#air): a bit error rate of 1e-3 at 100 m, rising steeply.
            Shadowing is off: it would make each distance of a pair larger or smaller by the same factor.
            Unicasts have %d bytes, %d seeds."""
                .formatted(LENGTH, seeds));
        List<PairRun> runs = new ArrayList<>();
        for (int seed = 0; seed < seeds; seed++) {
            runs.add(new PairRun(RADIO, settings.seed() + seed, settings.choose(SECONDS, 5), plans(distances)));
        }
        describe(reach(distances, Runs.all(runs, report)), seeds, report);
    }

    private static List<PairRun.Plan> plans(List<Integer> distances) {
        return distances.stream().map(metres -> new PairRun.Plan(new Field.Cell("Station",
                List.of(Map.of(), Map.of("position", List.of(0, metres)))), LENGTH)).toList();
    }

    private static Reach reach(List<Integer> distances, List<List<PairRun.Result>> ofSeeds) {
        Map<Integer, List<PairRun.Result>> ofDistance = new LinkedHashMap<>();
        for (int i = 0; i < distances.size(); i++) {
            int pair = i;
            ofDistance.put(distances.get(i), ofSeeds.stream().map(pairs -> pairs.get(pair)).toList());
        }
        return new Reach(ofDistance);
    }

    private static void describe(Reach reach, int seeds, Report report) {
        Table table = new Table("distance", "unicasts", "delivered", "of a seed");
        PairRun.Result all = PairRun.Result.NONE;
        for (int metres : reach.ofDistance.keySet()) {
            Ledger.Sum sum = reach.sum(metres).sum();
            table.row(metres + " m", sum.offered(), Table.percent(sum.delivered(), sum.offered()), Table.spread("%.1f",
                    reach.ofDistance.get(metres).stream().mapToDouble(each -> 100 * each.delivered())) + " %");
            all = all.plus(reach.sum(metres));
        }
        report.table(table);
        report.claim(Table.text("%.0f %% of %d bytes delivered up to", 100 * AIM_SHARE, LENGTH), reach.metres() + " m",
                ofSeeds(reach, seeds));
        all.sum().report(report);
        report.never("a unicast without an end", all.sum().open());
        report.never("a nonce with two messages", all.repeated());
    }

    private static String ofSeeds(Reach reach, int seeds) {
        return Table.spread("%.0f", IntStream.range(0, seeds).mapToDouble(seed -> reach.ofSeed(seed).metres())) + " m";
    }
}
