package mutation;

import harness.Report;
import harness.Table;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** How many mutants of the firmware's delivery the replay of their traces kills. */
final class FirmwareMutants implements Part {

    private static final double GOAL = 0.85;
    private static final int USUAL = 60;
    /** The seeds of the air. A mutant that the first does not kill has other chances. */
    private static final List<Long> SEEDS = List.of(1L, 2L, 3L, 4L);
    /**
     * The others decide how well a board hears, which no trace tells, or how its EEPROM keeps what it holds. Carrier
     * sense knows a carrier in several ways, of which in air without noise one is enough.
     */
    private static final Pattern SOURCES = Pattern.compile(
            "(delivery|secure)/.*|radio/(AskRadio|RadioEncoder|RadioQueue)\\.cpp|storage/BootEpoch\\.cpp");

    /** The fate of a mutant. */
    private enum Fate {
        UNBUILT, UNREACHED, REFUSED, FAILED, SURVIVED
    }

    private record Judged(FirmwareMutant mutant, Fate fate, String why) {}

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
        Path place = options.root().resolve("test/lab/mutation/build/firmware");
        List<FirmwareMutant> possible = FirmwareMutant.all(options.root()).stream()
                .filter(mutant -> SOURCES.matcher(mutant.file()).matches()).toList();
        List<FirmwareMutant> chosen = options.draw(Stream.of(false, true)
                .flatMap(lies -> options.draw(possible.stream().filter(mutant -> mutant.lies() == lies).toList(), USUAL)
                        .stream())
                .toList(), 2 * USUAL);
        BlockingQueue<FirmwareBuild> builds = new LinkedBlockingQueue<>();
        int workers = Runtime.getRuntime().availableProcessors();
        for (int i = 0; i < workers; i++) {
            builds.add(new FirmwareBuild(options.root(), place.resolve("" + i), FirmwareBuild.command()));
        }
        check(builds.peek(), options.recorded());
        ExecutorService threads = Executors.newFixedThreadPool(workers);
        List<Judged> judged = new ArrayList<>();
        try {
            List<Future<Judged>> running = chosen.stream()
                    .map(mutant -> threads.submit(() -> judged(mutant, builds, options))).toList();
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
    private static void check(FirmwareBuild build, Path recorded) throws IOException, InterruptedException {
        for (long seed : SEEDS) {
            Recording right = new Recording(recorded.resolve("unchanged"), seed);
            if (!right.isMade()) {
                right.make(build.build().orElseThrow(() -> new IOException("the firmware does not build")));
            }
            String why = right.refusal().orElse(right.hosts());
            if (!why.isEmpty()) {
                throw new IllegalStateException("the unchanged firmware, with seed " + seed + ": " + why);
            }
        }
    }

    private Judged judged(FirmwareMutant mutant, BlockingQueue<FirmwareBuild> builds, Options options)
            throws IOException, InterruptedException {
        Path folder = options.recorded().resolve(mutant.folderName());
        Path unbuilt = folder.resolve("unbuilt");
        String hosts = "";
        for (long seed : SEEDS) {
            Recording run = new Recording(folder, seed);
            if (!Files.exists(unbuilt) && !run.isMade()) {
                record(mutant, run, unbuilt, builds, options.root());
            }
            if (Files.exists(unbuilt)) {
                return new Judged(mutant, Fate.UNBUILT, "");
            }
            Optional<String> refusal = run.refusal();
            if (refusal.isPresent()) {
                return new Judged(mutant, Fate.REFUSED, refusal.get());
            }
            hosts = run.hosts().isEmpty() ? hosts : run.hosts();
        }
        return new Judged(mutant, !hosts.isEmpty() ? Fate.FAILED
                : isReached(mutant, builds, options, folder) ? Fate.SURVIVED : Fate.UNREACHED, hosts);
    }

    private static void record(FirmwareMutant mutant, Recording run, Path unbuilt, BlockingQueue<FirmwareBuild> builds,
            Path root) throws IOException, InterruptedException {
        FirmwareBuild build = builds.take();
        try {
            Files.createDirectories(run.folder());
            Files.writeString(run.folder().resolve("mutant"), mutant.toString());
            Optional<Path> program = build.with(mutant.file(), mutant.in(mutant.source(root)));
            if (program.isPresent()) {
                run.make(program.get());
            } else {
                Files.createFile(unbuilt);
            }
        } finally {
            builds.add(build);
        }
    }

    /** Whether boards come to the changed line; taken for granted where a trap cannot stand before it. */
    private static boolean isReached(FirmwareMutant mutant, BlockingQueue<FirmwareBuild> builds, Options options,
            Path folder) throws IOException, InterruptedException {
        Path known = folder.resolve("reached");
        if (!Files.exists(known)) {
            FirmwareBuild build = builds.take();
            try {
                Optional<Path> program = mutant.takesTrap()
                        ? build.with(mutant.file(), mutant.trapIn(mutant.source(options.root()))) : Optional.empty();
                boolean reached = program.isEmpty();
                for (long seed : SEEDS) {
                    reached = reached || new Recording(folder.resolve("trap"), seed).make(program.get());
                }
                Files.writeString(known, "" + reached);
            } finally {
                builds.add(build);
            }
        }
        return Files.readString(known).equals("true");
    }

    private void describe(List<Judged> judged, int possible, Options options, Report report) {
        report.text("""
            Of %d possible mutants of what decides when and what a board sends, %d were drawn, half of them of lines
            that tell a trace point, which lies then (*points*). Three emulated boards ran each four times, for 100 s
            of theirs at most: twice with bit errors, once with jams, twice in a line with a relay in the middle.
            *Refused*: the replay of a trace says that no board does this. *Only hosts*: the trace is accepted, but a
            message has no end, or has not come although it was reported so. *Not reached*: no board comes to the line.
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

    /** The number of mutants that boards come to, and that nobody has said are harmless. */
    private static long harmful(List<Judged> judged, Options options) {
        return judged.stream().filter(each -> each.fate != Fate.UNBUILT && each.fate != Fate.UNREACHED)
                .filter(each -> !isHarmless(each, options)).count();
    }

    private static boolean isHarmless(Judged judged, Options options) {
        return judged.fate == Fate.SURVIVED && options.survivors().isHarmless(judged.mutant.toString());
    }

    private static void survivors(List<Judged> judged, Survivors known, Report report) {
        String rows = judged.stream().filter(each -> each.fate == Fate.FAILED || each.fate == Fate.SURVIVED)
                .map(each -> "| " + each.mutant.file() + ":" + each.mutant.line() + " "
                        + Mutate.cell(each.mutant.right().strip()) + ", " + Mutate.cell(each.mutant.what()) + " | "
                        + (each.why + known.reason(each.mutant.toString()).orElse("")).replace("|", "\\|") + " |")
                .sorted().collect(Collectors.joining("\n"));
        if (!rows.isEmpty()) {
            report.text("Accepted:\n\n| changed line | what hosts saw, or why it does no harm or is unseen |\n"
                    + "| --- | --- |\n" + rows);
        }
    }
}
