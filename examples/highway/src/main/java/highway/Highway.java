package highway;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.Callable;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import uppaal.replay.Replay;

/** The launcher of the five-vehicle scenario: exit status 0 if all behaviours were observed and the model
 * allows what the boards did, 1 if not. */
@Command(name = "highway", description = "Runs the five-vehicle scenario on emulated boards.",
    mixinStandardHelpOptions = true)
public final class Highway implements Callable<Integer> {

    @Mixin
    private Options options;

    private Highway() { }

    /** Runs the scenario. */
    public static void main(String[] arguments) {
        CommandLine command = new CommandLine(new Highway());
        command.setParameterExceptionHandler((wrong, given) -> {
            wrong.getCommandLine().getErr().println("highway: " + wrong.getMessage());
            return CommandLine.ExitCode.USAGE;
        });
        System.exit(command.execute(arguments));
    }

    @Override
    public Integer call() {
        PrintStream out = new PrintStream(System.out, true, StandardCharsets.UTF_8);
        Timeline timeline = new Timeline(out, options.coloured());
        Scenario scenario = new Scenario(options, timeline);
        Runtime.getRuntime().addShutdownHook(new Thread(scenario::close, "end everything"));
        try (scenario) {
            run(scenario, timeline);
        } catch (IOException | Scenario.BrokenOffException reason) {
            timeline.warn("highway: broken off: " + reason.getMessage());
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
        }
        if (!scenario.agentsStarted()) {
            return CommandLine.ExitCode.SOFTWARE;
        }
        timeline.table(scenario.behaviours());
        Replay model = scenario.model();
        timeline.verdict(model.verdict(), model.refusal().isEmpty());
        return scenario.allObserved() && model.refusal().isEmpty() ? CommandLine.ExitCode.OK : CommandLine.ExitCode.SOFTWARE;
    }

    private void run(Scenario scenario, Timeline timeline)
            throws IOException, InterruptedException, Scenario.BrokenOffException {
        scenario.startBoards();
        scenario.provision();
        if (options.boardsOnly()) {
            timeline.note("the boards run; start the agents (README, \"Agents that you start by hand\"); end with Ctrl-C");
            scenario.stay();
        } else {
            scenario.startAgents();
            scenario.follow();
            scenario.draw();
        }
    }
}
