package highway;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import javino.cli.WrongUsage;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.UnmatchedArgumentException;
import uppaal.conformance.Replay;

/** The launcher of the five-vehicle scenario: exit status 0 if all behaviours were observed and the model
 * allows what the boards did, 1 if not; also of a run with a page that a signal ends, but that what was not seen yet
 * is no failure then. */
@Command(name = "highway", description = "Runs the five-vehicle scenario on emulated boards.")
public final class Highway implements Callable<Integer> {

    @Mixin
    private Options options;
    private volatile boolean over;

    Highway() {}

    /** Runs the scenario. */
    public static void main(String[] arguments) {
        System.exit(commandLine(new Highway()).execute(arguments));
    }

    /**
     * A command whose options the user gives to Gradle: they are called as there in the one line that tells a mistake.
     */
    static CommandLine commandLine(Object program) {
        CommandLine command = new CommandLine(program);
        command.setParameterExceptionHandler((wrong, given) -> {
            String text = wrong instanceof UnmatchedArgumentException unmatched ? "there is no option "
                    + unmatched.getUnmatched().get(0).replaceFirst("=.*", "") + "; there is "
                    + command.getCommandSpec().options()
                            .stream().filter(option -> !option.hidden()).map(OptionSpec::longestName)
                            .collect(Collectors.joining(", "))
                    : WrongUsage.describe(wrong);
            command.getErr().println(command.getCommandName() + ": " + text.replace("--", "-P"));
            return CommandLine.ExitCode.USAGE;
        });
        return command;
    }

    @Override
    public Integer call() {
        PrintStream out = new PrintStream(System.out, true, StandardCharsets.UTF_8);
        Timeline timeline = new Timeline(out, options.coloured());
        Scenario scenario = new Scenario(options, timeline);
        Runtime.getRuntime().addShutdownHook(new Thread(() -> {
            scenario.close();
            if (options.live() && scenario.agentsStarted()) {
                // Java's own status would be that of the signal.
                Runtime.getRuntime().halt(verdict(scenario, timeline, over));
            }
        }, "end everything"));
        try (scenario) {
            run(scenario, timeline);
        } catch (IOException | Scenario.BrokenOffException reason) {
            scenario.warn("highway: broken off: " + reason.getMessage());
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
        }
        if (!scenario.agentsStarted()) {
            return CommandLine.ExitCode.SOFTWARE;
        }
        timeline.table(scenario.behaviours());
        return verdict(scenario, timeline, true);
    }

    /** Says what the model thinks of the run; the exit status. */
    private static int verdict(Scenario scenario, Timeline timeline, boolean complete) {
        Replay model = scenario.model();
        boolean accepted = model.refusal().isEmpty();
        timeline.verdict(model.verdict(), accepted);
        return accepted && (scenario.allObserved() || !complete) ? CommandLine.ExitCode.OK
                : CommandLine.ExitCode.SOFTWARE;
    }

    private void run(Scenario scenario, Timeline timeline)
            throws IOException, InterruptedException, Scenario.BrokenOffException {
        scenario.startBoards();
        scenario.provision();
        if (options.boardsOnly()) {
            scenario.note(
                    "the boards run; start the agents (examples/highway/README.md, \"Agents that you start by hand\"); "
                            + "end with Ctrl-C");
            scenario.showPage();
            scenario.stay();
        } else {
            scenario.joinCells();
            scenario.startAgents();
            scenario.follow();
            over = true;
            scenario.draw();
            if (options.live()) {
                timeline.table(scenario.behaviours());
                scenario.note("the run goes on, on the page; end it with Ctrl-C");
                scenario.showPage();
                scenario.stay();
            }
        }
    }
}
