package campaign;

import harness.Report;
import harness.Results;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/**
 * Runs campaigns, prints their tables and writes their sections of docs/results.md. Exit status 1 if what must always
 * hold did not.
 */
@Command(name = "campaign", mixinStandardHelpOptions = true, description = "Shows what the link holds, in figures.")
public final class Campaigns implements Callable<Integer> {

    private static final long DEFAULT_SEED = 1;
    private static final long DEFAULT_MINUTES = 20;
    private static final List<Campaign> ALL =
            List.of(new Delivery(), new Range(), new Load(), new Relays(), new Modules(), new AirtimeLimits(),
                    new Actions(), new Faults(),
                    new Attacks(),
                    new Fuzzing(),
                    new Moves(), new KeyAgreements(), new Cells(), new Soak());

    @Option(names = "--only", split = ",", paramLabel = "NAME", description = "run these alone")
    private List<String> only = List.of();

    @Option(names = "--seed", paramLabel = "N", description = "start of all random numbers (default 1)")
    private long seed = DEFAULT_SEED;

    @Option(names = "--minutes", paramLabel = "N", description = "wall time of soak (default 20)")
    private long minutes = DEFAULT_MINUTES;

    @Option(names = "--moves", paramLabel = "N",
            description = "moves on emulated boards (default: as many as fit into 10 emulated minutes)")
    private int moves;

    private Campaigns() {}

    public static void main(String[] arguments) {
        CommandLine command = new CommandLine(new Campaigns());
        command.setParameterExceptionHandler((wrong, given) -> {
            wrong.getCommandLine().getErr().println("campaign: " + wrong.getMessage() + " (try --help)");
            return CommandLine.ExitCode.USAGE;
        });
        // Sessions run on threads that nothing else ends.
        System.exit(command.execute(arguments));
    }

    @Override
    public Integer call() throws Exception {
        List<String> known = ALL.stream().map(Campaign::name).toList();
        for (String name : only) {
            if (!known.contains(name)) {
                return misused("there is no campaign '" + name + "', but " + String.join(", ", known));
            }
        }
        if (minutes < 1) {
            return misused("--minutes must be at least 1, not " + minutes);
        }
        if (moves < 0) {
            return misused("--moves must be at least 1, not " + moves);
        }
        return run();
    }

    private static int misused(String what) {
        System.err.println("campaign: " + what);
        return CommandLine.ExitCode.USAGE;
    }

    private int run() throws Exception {
        Path root = Path.of(System.getProperty("javino.root"));
        Settings settings = new Settings(seed, false, Duration.ofMinutes(minutes), moves, root);
        List<String> violations = new ArrayList<>();
        for (Campaign campaign : ALL) {
            if (!only.isEmpty() && !only.contains(campaign.name())) {
                continue;
            }
            Report report = new Report(campaign.name(), System.err);
            try {
                campaign.run(settings, report);
            } finally {
                // The report is shown even if the model refuses the run, as it may when boards are switched off.
                System.out.println("\n" + campaign.name() + "\n" + report.screen() + "\n");
            }
            new Results(root).write(campaign.name(), "`" + command(campaign) + "`", report.claims(), report.markdown());
            violations.addAll(report.violations());
        }
        if (!violations.isEmpty()) {
            System.err.println("campaign: violated: " + String.join("; ", violations));
        }
        return violations.isEmpty() ? CommandLine.ExitCode.OK : CommandLine.ExitCode.SOFTWARE;
    }

    private String command(Campaign campaign) {
        String more = campaign instanceof Soak ? " -Pminutes=" + minutes
                : campaign instanceof Moves && moves > 0 ? " -Pmoves=" + moves
                        : "";
        return "gradle campaign -Ponly=" + campaign.name() + " -Pseed=" + seed + more;
    }
}
