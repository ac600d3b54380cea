package mutation;

import harness.Report;
import harness.Table;
import harness.Emulator;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import uppaal.conformance.Replay;

/** How many small changes of genuine traces the replay refuses. */
final class Traces implements Part {

    private static final double GOAL = 0.998;
    private static final int USUAL = 40;

    /** @param keys those of its run */
    private record Genuine(String name, List<String> lines, Path keys) {}

    private record Judged(TraceMutant mutant, String file, boolean refused) {}

    @Override
    public String name() {
        return "traces";
    }

    @Override
    public String section() {
        return "mutants of traces";
    }

    @Override
    public void run(Options options, Report report) throws Exception {
        long wronglyRefused = 0;
        Map<String, List<Judged>> byOperator = new LinkedHashMap<>();
        List<Genuine> traces = traces(options);
        for (Genuine trace : traces) {
            if (refused(trace.lines, new Replay(trace.keys))) {
                wronglyRefused++;
                report.progress("%s is refused as it is", trace.name);
                continue;
            }
            Map<String, List<TraceMutant>> mutants = TraceMutants.of(trace.lines, options.seed()).stream()
                    .collect(Collectors.groupingBy(TraceMutant::operator, LinkedHashMap::new, Collectors.toList()));
            mutants.forEach((operator, all) -> byOperator.computeIfAbsent(operator, any -> new ArrayList<>())
                    .addAll(options.draw(all, USUAL).parallelStream()
                            .map(mutant -> new Judged(mutant, trace.name,
                                    refused(mutant.lines().get(), new Replay(trace.keys))))
                            .toList()));
            report.progress("%s done", trace.name);
        }
        describe(byOperator, traces.size(), options, report);
        report.never("genuine traces refused", wronglyRefused);
    }

    /** Traces of some time ago, which are the same each time, and one of what the firmware does now. */
    private static List<Genuine> traces(Options options) throws IOException, InterruptedException {
        List<Genuine> traces = new ArrayList<>();
        for (Path file : files(options.root())) {
            String name = file.getFileName().toString();
            traces.add(new Genuine(name, Files.readAllLines(file),
                    file.resolveSibling(name.replace(".jsonl", ".keys"))));
        }
        Recording today = new Recording(options.recorded().resolve("unchanged"), options.seed());
        if (!today.isMade()) {
            today.make(Emulator.firmware("Station"));
        }
        if (!today.hosts().isEmpty()) {
            throw new IllegalStateException("unchanged: " + today.hosts());
        }
        traces.add(new Genuine("today's firmware", today.lines(), today.keys()));
        return traces;
    }

    /** Genuine traces, each beside the keys of its run, which everybody may know. */
    static List<Path> files(Path root) throws IOException {
        try (Stream<Path> files = Files.list(root.resolve("uppaal/replay/src/test/resources/traces"))) {
            return files.filter(file -> file.toString().endsWith(".jsonl")).sorted().toList();
        }
    }

    /** Whether the replay says no; a line that is none of a trace is refused too. */
    private static boolean refused(List<String> lines, Replay replay) {
        try {
            lines.forEach(replay::line);
            replay.finish();
        } catch (IllegalArgumentException wrong) {
            return true;
        }
        return replay.refusal().isPresent();
    }

    private static void describe(Map<String, List<Judged>> byOperator, int files, Options options, Report report) {
        report.text("""
            Each mutant is one of %d genuine traces with one change. They are those in
            `uppaal/replay/src/test/resources/traces`, and one of today's firmware, from the run of the unchanged
            firmware below. *Refused*: the replay says that no board does this. *Genuine*: boards may well do this, or
            no trace can show it; the reasons are below. *Unseen*: a trace could show it, and the
            replay does not look. Of each change and trace the seed has drawn at most %d mutants.
            """.formatted(files, options.mutants(USUAL)));
        Table table = new Table("change", "mutants", "refused", "genuine", "refused of all", "of the others");
        List<Judged> all = byOperator.values().stream().flatMap(List::stream).toList();
        byOperator.forEach((operator, judged) -> row(table, operator, judged, options.survivors()));
        row(table, "all", all, options.survivors());
        report.table(table);
        reasons(all, options.survivors(), report);
        long refused = all.stream().filter(Judged::refused).count();
        long harmful = harmful(all, options.survivors());
        report.claim("refused, of those not genuine", Table.of(refused, refused + harmful), "");
        report.claim("refused of all", Table.of(refused, all.size()), "");
        report.aim(Table.text("at least %.1f %% of those that are not genuine refused", 100 * GOAL),
                refused >= GOAL * (refused + harmful));
        report.never("survivors without a reason", all.stream().filter(each -> !each.refused)
                .filter(each -> options.survivors().reason(each.mutant.toString()).isEmpty()).count());
    }

    /** The number of accepted mutants that nobody has said are genuine. */
    private static long harmful(List<Judged> judged, Survivors known) {
        return judged.stream().filter(each -> !each.refused && !known.isHarmless(each.mutant.toString())).count();
    }

    private static void row(Table table, String name, List<Judged> judged, Survivors known) {
        long refused = judged.stream().filter(Judged::refused).count();
        long harmful = harmful(judged, known);
        table.row(name, judged.size(), refused, judged.size() - refused - harmful,
                Table.percent(refused, judged.size()), Table.percent(refused, refused + harmful));
    }

    /** Reports the mutants that were accepted, by change and event, with where they can be seen. */
    private static void reasons(List<Judged> all, Survivors known, Report report) {
        Map<String, List<Judged>> alike = new TreeMap<>(all.stream().filter(each -> !each.refused)
                .collect(Collectors.groupingBy(each -> each.mutant.toString())));
        if (alike.isEmpty()) {
            return;
        }
        Table excused = new Table("reason", "mutants", "of all");
        new TreeMap<>(alike.values().stream().flatMap(List::stream)
                .filter(each -> known.reason(each.mutant.toString()).isPresent()).collect(Collectors.groupingBy(
                        each -> known.reason(each.mutant.toString()).orElseThrow(), Collectors.counting())))
                .forEach((reason, count) -> excused.row(reason, count,
                        Table.percent(count, all.size())));
        report.text("So many mutants each reason excuses:");
        report.table(excused);
        report.text(
                "Accepted:\n\n| change and event | times | for one | genuine or unseen, since |\n"
                        + "| --- | ---: | --- | --- |\n"
                        + alike.entrySet().stream()
                                .map(each -> "| " + each.getKey().replace("|", "\\|") + " | " + each.getValue().size()
                                        + " | "
                                        + each.getValue().get(0).file + ", line " + each.getValue().get(0).mutant.line()
                                        + " | "
                                        + known.reason(each.getKey()).orElse("") + " |")
                                .collect(Collectors.joining("\n")));
    }
}
