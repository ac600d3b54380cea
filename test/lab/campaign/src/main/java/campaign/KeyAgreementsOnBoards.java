package campaign;

import harness.Certificates;
import harness.Emulator;
import harness.Report;
import harness.Table;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.function.Supplier;
import javino.protocol.Bytes;

/** Hosts that have never met, on emulated boards: how long the first message takes, and what disturbs it. */
final class KeyAgreementsOnBoards {

    private static final String SKETCH = "Station";
    private static final double FIRST_SECONDS = 3.0;
    private static final double LONGEST_SECONDS = 10.0;
    private static final double NOISY_SECONDS = 8.0;
    private static final double NOISE = 1e-3;
    private static final double MOST_CPU = 50;
    private static final double FAULT_WITHIN = 4;

    private final Settings settings;
    private final Report report;
    private double cpu;
    private long keys;
    private long lost;

    KeyAgreementsOnBoards(Settings settings, Report report) {
        this.settings = settings;
        this.report = report;
    }

    void run() throws Exception {
        Table table =
                new Table("bit errors", "seeds", "messages", "median", "95 %", "longest", "again: median", "95 %");
        List<Double> quiet = times(table, 0);
        List<Double> noisy = times(table, NOISE);
        report.text("""
            **On emulated boards.** Hosts with certificates of one authority, whose boards (`Station`) have no key,
            drive emulated Megas as an agent's host does. All times are emulated seconds, from the host's wish to send
            until the other host has the message, which came sealed. *Again* is when the sender's board was reset and
            is there again: its key is gone, and both hosts agree anew from what they have kept. A host answers another
            once in 5 s, so 6 s pass before each message. Pairs are out of each other's range.
            """);
        report.table(table);
        claim("first message in quiet air", quiet);
        claim("first message, 1e-03", noisy);
        report.aim(Table.text("first message in quiet air: median at most %.1f s (%.2f s)", FIRST_SECONDS,
                share(quiet, 0.5)), share(quiet, 0.5) <= FIRST_SECONDS);
        report.aim(Table.text("none of %d first messages in quiet air above %.0f s (%.2f s)", quiet.size(),
                LONGEST_SECONDS,
                share(quiet, 1)), share(quiet, 1) <= LONGEST_SECONDS);
        report.aim(Table.text("first message where one bit in 1000 is wrong: 95 %% in at most %.0f s (%.2f s)",
                NOISY_SECONDS, share(noisy, 0.95)), share(noisy, 0.95) <= NOISY_SECONDS);
        together();
        faults();
        siege();
        double each = cpu / keys;
        report.claim("CPU of a host for one agreement", Table.text("%.1f ms", each), "mean of " + keys);
        report.aim(
                Table.text("a host's CPU for one agreement: at most %.0f ms (%.1f ms on average of %d)", MOST_CPU, each,
                        keys),
                each <= MOST_CPU);
        report.never("on boards: a message that does not come", lost);
    }

    private void claim(String what, List<Double> waits) {
        report.claim(what, seconds(share(waits, 0.5)), "at most " + seconds(share(waits, 1)));
    }

    /** The work to do with each pair, side by side. */
    private interface Doing {

        List<Double> with(CertifiedPair pair, Random random);
    }

    private List<List<Double>> pairs(int cells, int pairsInCell, double bitErrors, long seed, Doing doing)
            throws Exception {
        List<CertifiedPair> pairs = new ArrayList<>();
        Emulator.Scenario scenario = new Emulator.Scenario().seed(seed).discardEvents().inEmulatedTime()
                .radio("bitErrorRate", bitErrors).listener(event -> pairs.forEach(pair -> pair.traced(event)));
        try (Closing closing = new Closing()) {
            Field field = closing.add(Field.start(scenario,
                    Collections.nCopies(cells, new Field.Cell(SKETCH, 2 * pairsInCell)), report));
            EmulatedTime time = new EmulatedTime();
            Certificates authority = new Certificates(field.folder(), "authority");
            for (int cell = 0; cell < cells; cell++) {
                for (int i = 0; i < pairsInCell; i++) {
                    pairs.add(closing.add(new CertifiedPair(field, time, cell, i, authority)));
                }
            }
            List<Supplier<List<Double>>> all = new ArrayList<>();
            for (int i = 0; i < pairs.size(); i++) {
                CertifiedPair pair = pairs.get(i);
                Random random = new Random(seed * 100 + i);
                all.add(() -> doing.with(pair, random));
            }
            return time.all(all);
        } finally {
            pairs.forEach(pair -> {
                cpu += pair.cpu();
                keys += pair.keysSet();
                report.progress("%s", pair.warnings());
            });
        }
    }

    private double came(OptionalDouble took) {
        if (took.isEmpty()) {
            lost++;
        }
        return took.orElse(CertifiedPair.PATIENCE);
    }

    private List<Double> times(Table table, double bitErrors) throws Exception {
        int rounds = settings.choose(8, 1);
        int seeds = settings.choose(8, 1);
        List<Double> first = new ArrayList<>();
        List<Double> again = new ArrayList<>();
        for (int seed = 0; seed < seeds; seed++) {
            pairs(settings.choose(8, 1), 1, bitErrors, settings.seed() + seed, (pair, random) -> {
                for (int round = 0; round < rounds; round++) {
                    pair.rest();
                    pair.forget();
                    double took = came(pair.deliver());
                    pair.rest();
                    pair.reset();
                    double tookAgain = came(pair.deliver());
                    first.add(took);
                    again.add(tookAgain);
                }
                return List.of();
            });
            report.progress("bit errors %s, seed %d: %s, again %s", bitErrors, settings.seed() + seed, spread(first),
                    spread(again));
        }
        table.row(bitErrors == 0 ? "0" : Double.toString(bitErrors), seeds, first.size(), seconds(share(first, 0.5)),
                seconds(share(first, 0.95)), seconds(share(first, 1)), seconds(share(again, 0.5)),
                seconds(share(again, 0.95)));
        return first;
    }

    /** All in one range begin at once. */
    private void together() throws Exception {
        int pairs = settings.choose(8, 2);
        Table table = new Table("pairs in one range", "seed", "first of them", "median", "last of them");
        for (int seed = 0; seed < settings.choose(3, 1); seed++) {
            List<Double> all = pairs(1, pairs, 0, settings.seed() + seed,
                    (pair, random) -> List.of(came(pair.deliver()))).stream().flatMap(List::stream).toList();
            table.row(pairs, settings.seed() + seed, seconds(share(all, 0)), seconds(share(all, 0.5)),
                    seconds(share(all, 1)));
            report.progress("%d pairs at once: %s", pairs, spread(all));
        }
        report.text("All pairs in one range begin at the same moment.");
        report.table(table);
    }

    /** A board is reset or loses power at a random moment of the agreement. */
    private void faults() throws Exception {
        Table table = new Table("fault within " + (int) FAULT_WITHIN + " s", "how often", "median until it comes",
                "longest", "most agreements after it");
        for (String fault : List.of("reset", "power-cut")) {
            List<Double> took = new ArrayList<>();
            List<Long> agreements = new ArrayList<>();
            int rounds = settings.choose(4, 1);
            pairs(settings.choose(4, 1), 1, 0, settings.seed() + 10, (pair, random) -> {
                for (int round = 0; round < rounds; round++) {
                    pair.rest();
                    pair.forget();
                    long before = pair.keysSet();
                    pair.later(random.nextDouble() * FAULT_WITHIN, fault, random.nextBoolean());
                    double each = came(pair.deliver());
                    pair.awaitFault();
                    double calm = came(pair.deliver());
                    took.add(each + calm);
                    agreements.add((pair.keysSet() - before) / 2);
                }
                return List.of();
            });
            claim("first message, " + fault, took);
            table.row(fault, took.size(), seconds(share(took, 0.5)), seconds(share(took, 1)),
                    Collections.max(agreements));
            report.progress("%s: %s, agreements %s", fault, spread(took), agreements);
        }
        report.text("""
            One of the two boards is reset, or loses power and RAM for 0.3 s, at a random moment after the host's wish.
            Then the sender speaks once more. Both messages have to come.
            """);
        report.table(table);
    }

    /** An attacker has his say where both hosts have met once by their certificates, and once again. */
    private void siege() throws Exception {
        int messages = settings.choose(300, 10);
        List<Double> found = pairs(1, 1, 0, settings.seed() + 20, (pair, random) -> {
            pair.rest();
            came(pair.deliver());
            pair.rest();
            pair.reset();
            came(pair.deliver());
            pair.rest();
            long before = pair.keysSet();
            List<Bytes> eeproms = pair.eeproms();
            pair.besiege(random, messages);
            pair.rest();
            boolean written = !eeproms.equals(pair.eeproms());
            came(pair.deliver());
            return List.of(written ? 1.0 : 0, (double) (pair.keysSet() - before), (double) pair.strange());
        }).get(0);
        report.text("""
            Where both hosts have met, and met again after a reset, an attacker in their range sends a packet every
            0.7 s: words that he makes up, words of theirs as they were, changed, mixed, or back to who said them, in
            the name of either or of somebody else; frames that look sealed, and their own sealed ones once more. Then
            the sender speaks, and needs no other key.
            """);
        report.never("on boards: EEPROMs changed by " + messages + " messages of an attacker",
                found.get(0).longValue());
        report.never("on boards: keys that these made hosts set", found.get(1).longValue());
        report.never("on boards: messages of his that were accepted", found.get(2).longValue());
    }

    private static double share(List<Double> figures, double share) {
        double[] sorted = figures.stream().mapToDouble(Double::doubleValue).toArray();
        Arrays.sort(sorted);
        return sorted[Math.min(sorted.length - 1, (int) (share * sorted.length))];
    }

    private static String seconds(double figure) {
        return Table.text("%.2f s", figure);
    }

    private static String spread(List<Double> figures) {
        return Table.spread("%.2f", figures.stream().mapToDouble(Double::doubleValue)) + " s";
    }
}
