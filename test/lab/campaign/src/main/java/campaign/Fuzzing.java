package campaign;

import fuzz.Run;
import fuzz.Target;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;

import harness.Report;
import harness.Table;

/** Jazzer on the Java decoders and libFuzzer on the firmware's sources, ten minutes each. */
final class Fuzzing implements Campaign {

    private static final int SECONDS = 600;

    /** @param run the run of a target, and how long it was given. */
    private record Result(Target target, Run run, int seconds) {}

    @Override
    public String name() {
        return "fuzz";
    }

    @Override
    public void run(Settings settings, Report report) throws Exception {
        report.text(
                """
            Jazzer tries the decoders in Java, libFuzzer the sources of the firmware, built for the PC with
            AddressSanitizer and UndefinedBehaviorSanitizer; the first lines of each target in `test/fuzz` say what it
            demands. Each side shares its time among its targets. *Inputs* were tried beyond the kept corpus; *edges* of
            the code were reached, in each fuzzer's own count. Inputs that reached further than the corpus are in
            `test/fuzz/build/found`; `test/fuzz/README.md` tells how to keep them.""");
        List<Target> firmware = Target.ofFirmware(settings.root().resolve("test/fuzz/native/build"));
        List<Target> java = Target.ofJava();
        List<Result> results = new ArrayList<>();
        ExecutorService sides = Executors.newFixedThreadPool(2);
        try {
            List<Future<List<Result>>> both = new ArrayList<>();
            for (List<Target> side : List.of(java, firmware)) {
                List<Target> targets = settings.choose(side, side.subList(0, 1));
                both.add(sides.submit(() -> run(targets, settings, report)));
            }
            for (Future<List<Result>> side : both) {
                results.addAll(side.get());
            }
        } finally {
            sides.shutdownNow();
        }
        describe(results, report);
    }

    private static List<Result> run(List<Target> targets, Settings settings, Report report) throws Exception {
        int seconds = settings.choose(SECONDS, targets.size()) / targets.size();
        Path build = settings.root().resolve("test/fuzz/build");
        List<Result> results = new ArrayList<>();
        for (Target target : targets) {
            Run run = Run.of(target, build.resolve("found").resolve(target.name()),
                    List.of(build.resolve("corpus").resolve(target.name())), "-seed=" + settings.seed(),
                    "-max_total_time=" + seconds);
            report.progress("%s: %d inputs%s", target.name(), run.executed(),
                    run.failure().isEmpty() ? "" : ", one fails:\n" + run.failure());
            results.add(new Result(target, run, seconds));
        }
        return results;
    }

    private static void describe(List<Result> results, Report report) {
        Table table = new Table("target", "time", "inputs", "edges");
        for (Result each : results) {
            table.row(each.target.name(), each.seconds + " s", each.run.executed(), each.run.covered());
        }
        report.table(table);
        report.claim("inputs tried, " + results.size() + " targets",
                "" + results.stream().mapToLong(each -> each.run.executed()).sum(), "");
        report.never("an input that fails", results.stream().filter(each -> !each.run.failure().isEmpty()).count());
    }
}
