package mutation;

import harness.Report;
import harness.Results;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/**
 * Makes mutants of models, traces and the firmware, prints how many are killed, and writes that into
 * docs/results.md. Exit status 1 if a mutant survives that nobody has given a reason for.
 */
@Command(name = "mutate", mixinStandardHelpOptions = true,
        description = "Shows what the models' properties and the replay kill.")
public final class Mutate implements Callable<Integer> {

    private static final List<Part> ALL = List.of(new Models(), new Traces(), new FirmwareMutants());

    @Option(names = "--only", split = ",", paramLabel = "NAME", description = "models, traces, firmware")
    private List<String> only = ALL.stream().map(Part::name).toList();

    @Option(names = "--seed", paramLabel = "N", description = "which mutants are drawn (default 1)")
    private long seed = 1;

    @Option(names = "--mutants", paramLabel = "N",
            description = "of each model, of each change of a trace, and of the firmware so many (250, 40, 60)")
    private Integer mutants;

    @Option(names = "--recorded", paramLabel = "FOLDER",
            description = "what boards did with mutants of the firmware; what is missing there is recorded")
    private Path recorded;

    private Mutate() {}

    public static void main(String[] arguments) {
        CommandLine command = new CommandLine(new Mutate());
        command.setParameterExceptionHandler((wrong, given) -> {
            wrong.getCommandLine().getErr().println("mutate: " + wrong.getMessage() + " (try --help)");
            return CommandLine.ExitCode.USAGE;
        });
        System.exit(command.execute(arguments));
    }

    @Override
    public Integer call() throws Exception {
        List<String> known = ALL.stream().map(Part::name).toList();
        for (String name : only) {
            if (!known.contains(name)) {
                System.err.println("mutate: --only takes some of " + String.join(",", known) + ", not '" + name + "'");
                return CommandLine.ExitCode.USAGE;
            }
        }
        Path root = Path.of(System.getProperty("javino.root"));
        Options options = new Options(seed, Optional.ofNullable(mutants),
                Survivors.read(root.resolve("test/lab/mutation/survivors.txt")), root,
                recorded == null ? root.resolve("test/lab/mutation/build/recorded") : recorded);
        List<String> violations = new ArrayList<>();
        for (Part part : ALL) {
            if (only.contains(part.name())) {
                violations.addAll(run(part, options));
            }
        }
        violations.forEach(violation -> System.err.println("mutate: " + violation));
        return violations.isEmpty() ? CommandLine.ExitCode.OK : CommandLine.ExitCode.SOFTWARE;
    }

    private List<String> run(Part part, Options options) throws Exception {
        Report report = new Report(part.name(), System.err);
        part.run(options, report);
        System.out.println("\n" + part.section() + "\n" + report.screen() + "\n");
        new Results(options.root()).write(part.section(), "`gradle mutate -Ponly=" + part.name()
                + (mutants == null ? "" : " -Pmutants=" + mutants) + " -Pseed=" + seed + "`", report.claims(),
                report.markdown());
        return report.violations();
    }

    /** A text as a cell of a table has it. */
    static String cell(String text) {
        return "`" + text.replace("|", "\\|") + "`";
    }
}
