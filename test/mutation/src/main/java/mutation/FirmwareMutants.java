package mutation;

import campaign.Report;
import campaign.Table;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/** How many mutants of the firmware's delivery the replay of their traces kills. */
final class FirmwareMutants implements Part {

    private static final double GOAL = 0.85;
    private static final int USUAL = 60;
    /** So begins the reason for a survivor that does harm. */
    private static final String UNSEEN = "unseen: ";
    /** So the trace says that a program has left its flash. */
    private static final String CRASH = "\"event\":\"crash\"";
    /** Of the air. A mutant that the first does not kill has other chances. */
    private static final List<Long> SEEDS = List.of(1L, 2L, 3L, 4L, 5L, 6L, 7L, 8L);
    /**
     * The others decide how well a board hears, which no trace tells, or how its EEPROM keeps what it holds. Carrier
     * sense knows a carrier in several ways, of which in air without noise one is enough.
     */
    private static final Pattern SOURCES = Pattern.compile(
            "(delivery|secure)/.*|radio/(AskRadio|RadioEncoder|RadioQueue)\\.cpp|storage/BootEpoch\\.cpp");

    /** What became of a mutant. */
    private enum Fate {
        UNBUILT, UNREACHED, REFUSED, FAILED, SURVIVED
    }

    private record Judged(FirmwareMutant mutant, Fate fate, String why) {}

    /** Why runs of the right firmware did not go well. A trap that no board comes to changes nothing. */
    private final Queue<String> refused = new ConcurrentLinkedQueue<>();
    private final Queue<String> failed = new ConcurrentLinkedQueue<>();

    @Override
    public String name() {
        return "firmware";
    }

    @Override
    public String section() {
        return "mutants of the firmware, by replay";
    }

    @Override
    public void run(Options options, Report report) throws Exception {
        Path place = options.root().resolve("test/mutation/build/firmware");
        List<FirmwareMutant> possible = FirmwareMutant.all(options.root()).stream()
                .filter(mutant -> SOURCES.matcher(mutant.file()).matches() && !mutant.onlyCounts()).toList();
        List<FirmwareMutant> chosen = options.draw(possible, USUAL);
        BlockingQueue<FirmwareBuild> builds = new LinkedBlockingQueue<>();
        int workers = Runtime.getRuntime().availableProcessors();
        for (int i = 0; i < workers; i++) {
            builds.add(new FirmwareBuild(options.root(), place.resolve("" + i), FirmwareBuild.command()));
        }
        check(builds.peek());
        ExecutorService threads = Executors.newFixedThreadPool(workers);
        List<Judged> judged = new ArrayList<>();
        try {
            List<Future<Judged>> running = chosen.stream()
                    .map(mutant -> threads.submit(() -> judged(mutant, builds, options.root()))).toList();
            for (Future<Judged> each : running) {
                judged.add(each.get());
                report.progress("%d of %d: %s: %s %s", judged.size(), chosen.size(), each.get().mutant,
                        each.get().fate, each.get().why);
            }
        } finally {
            threads.shutdownNow();
        }
        describe(judged, possible.size(), options, report);
    }

    /** Unchanged firmware must pass, or nothing can be said of mutants. */
    private static void check(FirmwareBuild build) throws IOException, InterruptedException {
        Path program = build.build().orElseThrow(() -> new IOException("the firmware does not build"));
        for (long seed : SEEDS) {
            DeliveryRun.Result result = converse(program, seed, line -> {});
            if (result.end() != DeliveryRun.End.FINE) {
                throw new IllegalStateException("the unchanged firmware, with seed " + seed + ": " + result.why());
            }
        }
    }

    private static DeliveryRun.Result converse(Path program, long seed, Consumer<String> trace)
            throws IOException, InterruptedException {
        Path folder = Files.createTempDirectory("javino-mutate");
        try {
            return DeliveryRun.run(program, seed, folder, trace);
        } finally {
            FirmwareBuild.delete(folder);
        }
    }

    private Judged judged(FirmwareMutant mutant, BlockingQueue<FirmwareBuild> builds, Path root)
            throws IOException, InterruptedException {
        FirmwareBuild build = builds.take();
        try {
            String source = mutant.source(root);
            Optional<Path> program = build.with(mutant.file(), mutant.in(source));
            if (program.isEmpty()) {
                return new Judged(mutant, Fate.UNBUILT, "");
            }
            Judged failed = null;
            for (long seed : SEEDS) {
                DeliveryRun.Result result = converse(program.get(), seed, line -> {});
                if (result.kept().isPresent()) {
                    Files.delete(result.kept().get());
                    return new Judged(mutant, Fate.REFUSED, result.why());
                }
                if (result.end() == DeliveryRun.End.FAILED) {
                    failed = new Judged(mutant, Fate.FAILED, result.why());
                }
            }
            return failed != null ? failed
                    : new Judged(mutant, isReached(mutant, source, build) ? Fate.SURVIVED : Fate.UNREACHED, "");
        } finally {
            builds.add(build);
        }
    }

    /** Whether boards come to the changed line; taken for granted where a trap cannot stand before it. */
    private boolean isReached(FirmwareMutant mutant, String source, FirmwareBuild build)
            throws IOException, InterruptedException {
        Optional<Path> program =
                mutant.takesTrap() ? build.with(mutant.file(), mutant.trapIn(source)) : Optional.empty();
        if (program.isEmpty()) {
            return true;
        }
        for (long seed : SEEDS) {
            AtomicBoolean crashed = new AtomicBoolean();
            DeliveryRun.Result result = converse(program.get(), seed, line -> {
                if (line.contains(CRASH)) {
                    crashed.set(true);
                }
            });
            if (crashed.get()) {
                if (result.kept().isPresent()) {
                    Files.delete(result.kept().get());
                }
                return true;
            }
            String why = "seed " + seed + ": " + result.why() + result.kept().map(file -> ", see " + file).orElse("");
            switch (result.end()) {
                case FINE -> {}
                case REFUSED -> refused.add(why);
                case FAILED -> failed.add(why);
            }
        }
        return false;
    }

    private void describe(List<Judged> judged, int possible, Options options, Report report) {
        report.text("""
            Of %d possible mutants of what decides when and what a board sends (another operator, a number greater or
            less by one or twice as large, a negated condition, a removed statement, true for false), %d were drawn.
            Lines that only count are left out. Each was planted alone into `Station`, which three emulated boards then
            ran eight times, for 100 s of theirs at most, four times with a bit error rate of 0.001, twice with short
            jams: unicasts, multicasts, broadcasts and contents in fragments, to partners that are there, away for a
            while or never there, with a reset, a loss of power, and an attacker who repeats what was on the air, as it
            was or changed. *Refused*: the replay of a trace says that no board does this. *Only hosts*: the trace is
            accepted, but a message has no end, or has not come although it was reported so. *Not reached*: no board
            comes to the line, or to the part of it that is changed. No board is a relay here. Hosts run in wall
            time: on a machine that has much else to do they say less, and fewer mutants die.
            """.formatted(possible, judged.size()));
        Table table = new Table("folder", "drawn", "not built", "not reached", "refused", "only hosts", "neither",
                "harmless", "refused of the others");
        for (String folder : judged.stream().map(each -> each.mutant.folder()).distinct().sorted().toList()) {
            row(table, folder, judged.stream().filter(each -> each.mutant.folder().equals(folder)).toList(), options);
        }
        row(table, "all", judged, options);
        report.table(table);
        survivors(judged, options.survivors(), report);
        long harmful = harmful(judged, options);
        report.claim("refused, of those reached and harmful", Table.of(count(judged, Fate.REFUSED), harmful),
                "");
        report.aim(Table.text("at least %.0f %% of those that are reached and do harm refused", 100 * GOAL),
                count(judged, Fate.REFUSED) >= GOAL * harmful);
        report.never("survivors without a reason",
                judged.stream().filter(each -> each.fate == Fate.SURVIVED)
                        .filter(each -> options.survivors().reason(each.mutant.toString()).isEmpty()).count());
        refused.forEach(why -> report.progress("genuine, but refused: %s", why));
        report.never("runs of unchanged firmware refused", refused.size());
        failed.forEach(why -> report.progress("unchanged, but hosts failed: %s", why));
        report.text("Runs of unchanged firmware in which hosts did not get what they must: " + failed.size() + ".");
    }

    private static void row(Table table, String name, List<Judged> judged, Options options) {
        table.row(name, judged.size(), count(judged, Fate.UNBUILT), count(judged, Fate.UNREACHED),
                count(judged, Fate.REFUSED), count(judged, Fate.FAILED), count(judged, Fate.SURVIVED),
                judged.stream().filter(each -> isHarmless(each, options)).count(),
                Table.percent(count(judged, Fate.REFUSED), harmful(judged, options)));
    }

    private static long count(List<Judged> judged, Fate fate) {
        return judged.stream().filter(each -> each.fate == fate).count();
    }

    /** Those that boards come to, and nobody has said are harmless. */
    private static long harmful(List<Judged> judged, Options options) {
        return judged.stream().filter(each -> each.fate != Fate.UNBUILT && each.fate != Fate.UNREACHED)
                .filter(each -> !isHarmless(each, options)).count();
    }

    private static boolean isHarmless(Judged judged, Options options) {
        return judged.fate == Fate.SURVIVED && options.survivors().reason(judged.mutant.toString())
                .filter(reason -> !reason.startsWith(UNSEEN)).isPresent();
    }

    private static void survivors(List<Judged> judged, Survivors known, Report report) {
        list("Accepted by the replay, but not by the hosts:\n\n| changed line | what hosts saw |", judged,
                each -> each.fate == Fate.FAILED, each -> each.why, report);
        list("Survivors:\n\n| changed line | does no harm, since; or is unseen, since |", judged,
                each -> each.fate == Fate.SURVIVED, each -> known.reason(each.mutant.toString()).orElse(""), report);
    }

    private static void list(String head, List<Judged> judged, Predicate<Judged> which,
            Function<Judged, String> why, Report report) {
        String rows = judged.stream().filter(which)
                .map(each -> "| " + each.mutant.file() + ":" + each.mutant.line() + " "
                        + Mutate.cell(each.mutant.right().strip()) + ", " + Mutate.cell(each.mutant.what()) + " | "
                        + why.apply(each).replace("|", "\\|") + " |")
                .sorted().collect(Collectors.joining("\n"));
        if (!rows.isEmpty()) {
            report.text(head + "\n| --- | --- |\n" + rows);
        }
    }
}
