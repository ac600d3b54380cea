package campaign;

import harness.Emulator;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;

/** Boards in one range that all send, at rising load, with and without carrier sense. */
final class Load implements Campaign {

    private static final int LENGTH = 16;
    private static final double BIT_RATE = 2000;
    /** A sealed content of 16 bytes and its acknowledgement: 40 and 18 bytes of payload (SPEC 6). */
    private static final double AIRTIME_SECONDS = (84 + 12 * 40 + 84 + 12 * 18) / BIT_RATE;
    private static final long PATIENCE_SECONDS = 180;
    private static final double CAMPAIGN_SECONDS = 40;
    private static final double TEST_SECONDS = 8;
    private static final double AIM_LOAD = 0.5;
    private static final double AIM_SHARE = 0.9;
    private static final String WITH = "Station";
    private static final String WITHOUT = "DeafStation";

    /** @param load airtime of messages and acknowledgements over time, if each were sent once. */
    private record Case(int boards, double load, String sketch) {

        Field.Cell cell() {
            return new Field.Cell(sketch, boards);
        }

        double secondsBetween() {
            return AIRTIME_SECONDS * boards / load;
        }
    }

    /** @param fairness Jain's index of the boards' shares: 1 if all are equal, 1/n if one has all. */
    private record Result(Ledger.Sum sum, double fairness, double least, double load, double packets) {}

    private final Map<Case, Result> results = new LinkedHashMap<>();
    private long repeated;

    @Override
    public String name() {
        return "load";
    }

    @Override
    public void run(Settings settings, Report report) throws Exception {
        results.clear();
        repeated = 0;
        for (List<Case> group : groups(cases(settings))) {
            run(group, settings);
            for (Case each : group) {
                report.progress("%d boards, %.0f %% load, %s: %s delivered", each.boards, 100 * each.load, each.sketch,
                        delivered(each));
            }
        }
        describe(settings, report);
    }

    private static List<Case> cases(Settings settings) {
        List<Case> cases = new ArrayList<>();
        for (double load : settings.choose(List.of(0.1, 0.25, 0.5, 0.75, 1.0), List.of(AIM_LOAD))) {
            for (String sketch : List.of(WITH, WITHOUT)) {
                for (int boards : settings.choose(List.of(20, 10, 5, 2), List.of(4))) {
                    cases.add(new Case(boards, load, sketch));
                }
            }
        }
        return cases;
    }

    /** Cases that fit one emulator, as many at a time as fit. */
    private static List<List<Case>> groups(List<Case> cases) {
        List<List<Case>> groups = new ArrayList<>();
        for (Case each : cases) {
            List<Case> group = groups.stream().filter(some -> boards(some) + each.boards <= Field.MOST_BOARDS)
                    .findFirst().orElse(null);
            if (group == null) {
                groups.add(group = new ArrayList<>());
            }
            group.add(each);
        }
        return groups;
    }

    private static int boards(List<Case> cases) {
        return cases.stream().mapToInt(Case::boards).sum();
    }

    private void run(List<Case> group, Settings settings) throws Exception {
        AirUsage air = new AirUsage();
        Timetable timetable = new Timetable();
        Emulator.Scenario scenario = timetable.scenario(settings.seed(), air);
        try (Closing closing = new Closing()) {
            closing.add(timetable);
            Field field = closing.add(Field.start(scenario, group.stream().map(Case::cell).toList()));
            List<Ring> rings = new ArrayList<>();
            for (int cell = 0; cell < group.size(); cell++) {
                rings.add(closing.add(new Ring(field, cell, LENGTH)));
            }
            double seconds = settings.choose(CAMPAIGN_SECONDS, TEST_SECONDS);
            double end = timetable.now() + seconds;
            for (int cell = 0; cell < group.size(); cell++) {
                rings.get(cell).offer(timetable, settings.seed() + cell, group.get(cell).secondsBetween(), end);
            }
            if (!timetable.await(end, field.emulator().process())) {
                throw new java.io.IOException("the emulator ended: " + field.emulator().complaints());
            }
            awaitEnds(rings);
            for (int cell = 0; cell < group.size(); cell++) {
                Ring ring = rings.get(cell);
                results.put(group.get(cell), result(ring.sums(), seconds, air.of(ring.posts())));
            }
            repeated += air.nonces().repeated();
        }
    }

    private static void awaitEnds(List<Ring> rings) throws InterruptedException {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_SECONDS);
        while (System.nanoTime() - end < 0
                && rings.stream().flatMap(ring -> ring.sums().stream()).anyMatch(sum -> sum.open() > 0)) {
            TimeUnit.MILLISECONDS.sleep(100);
        }
    }

    private static Result result(List<Ledger.Sum> sums, double seconds, AirUsage.Sum air) {
        Ledger.Sum all = sums.stream().reduce(Ledger.Sum.ZERO, Ledger.Sum::plus);
        List<Double> shares = sums.stream().filter(sum -> sum.offered() > 0)
                .map(sum -> (double) sum.delivered() / sum.offered()).toList();
        double total = shares.stream().mapToDouble(share -> share).sum();
        double squares = shares.stream().mapToDouble(share -> share * share).sum();
        return new Result(all, squares == 0 ? 0 : total * total / (shares.size() * squares),
                shares.stream().mapToDouble(share -> share).min().orElse(0), all.offered() * AIRTIME_SECONDS / seconds,
                (double) air.packets() / all.offered());
    }

    private String delivered(Case of) {
        Ledger.Sum sum = results.get(of).sum;
        return Table.percent(sum.delivered(), sum.offered());
    }

    private void describe(Settings settings, Report report) {
        report.text(
                """
            All boards of a row are in one range. Each sends sealed contents of 16 bytes to its neighbour at random
            times (Poisson), for %.0f s; then the run waits for all of them. *Load*: the measured share of the air's
            time that messages and acknowledgements would take if each were sent once. *Delivered*: the share of the
            offered messages that was reported delivered; a message that a full queue refused counts as offered.
            *Fairness*: Jain's index of the boards' shares. *Without* carrier sense boards run
            `test/system/sketches/DeafStation`, which begins to send even if others are on the air, and listens only for
            the answer to its own message; all else is the same."""
                        .formatted(settings.choose(CAMPAIGN_SECONDS, TEST_SECONDS)));
        Table table = new Table("boards, load", "unicasts", "load", "delivered", "least of a board", "fairness",
                "packets each",
                "without: delivered", "least of a board", "fairness", "packets each");
        cases(settings).stream().filter(each -> each.sketch.equals(WITH))
                .sorted(java.util.Comparator.comparingInt(Case::boards)
                        .thenComparingDouble(Case::load))
                .forEach(each -> row(table, each));
        report.table(table);
        report.aim("at 50 % offered load at least 90 % delivered, however many boards", results.entrySet().stream()
                .filter(each -> each.getKey().load == AIM_LOAD && each.getKey().sketch.equals(WITH))
                .map(each -> each.getValue().sum)
                .allMatch(sum -> sum.delivered() >= AIM_SHARE * sum.offered()));
        Ledger.Sum all = results.values().stream().map(Result::sum).reduce(Ledger.Sum.ZERO, Ledger.Sum::plus);
        all.report(report);
        report.never("a unicast without an end", all.open());
        report.never("a nonce with two messages", repeated);
    }

    private void row(Table table, Case with) {
        Result result = results.get(with);
        Case without = new Case(with.boards, with.load, WITHOUT);
        Result deaf = results.get(without);
        table.row(Table.text("%d boards, %.0f %%", with.boards, 100 * with.load), result.sum.offered(),
                Table.text("%.0f %%", 100 * result.load),
                delivered(with), Table.text("%.0f %%", 100 * result.least), Table.text("%.3f", result.fairness),
                Table.text("%.2f", result.packets),
                delivered(without), Table.text("%.0f %%", 100 * deaf.least), Table.text("%.3f", deaf.fairness),
                Table.text("%.2f", deaf.packets));
    }
}
