package trace.why;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import javino.JavinoException;
import javino.cli.CommandPlugin;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import trace.MalformedEventException;
import trace.TraceReader;

/** {@code javino why}: answers why something happened in a run, or why not. */
@Command(name = "why", description = {"Answers why something happened in a run, or why it did not.",
        "It follows the log of the run back to the first cause: a sensor, a packet, a goal of the program, or what was "
                + "refused, and by what."})
public final class WhyCommand implements CommandPlugin {

    @Parameters(index = "0", paramLabel = "FILE",
            description = "The log of a run: run.jsonl in the folder of a scenario that gradle test has played.")
    private Path file;

    @Parameters(index = "1", arity = "0..1", paramLabel = "WHAT",
            description = "A pin or belief as 'lamp(on)', an action as 'lampOn', a goal as '!go', or an event as "
                    + "'+dark(_)'.")
    private String what;

    @Option(names = "--at", paramLabel = "S", description = "Ask of what happened at that time of the run, in seconds.")
    private Double at;

    @Option(names = "--from", paramLabel = "AGENT",
            description = "Ask this agent, where several could be meant.")
    private String agent;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws JavinoException, IOException {
        if (what == null == (at == null)) {
            throw new ParameterException(spec.commandLine(), "why takes either WHAT, such as 'lamp(on)', or --at S");
        }
        if (agent != null && agent.isEmpty()) {
            throw new ParameterException(spec.commandLine(), "--from takes the name of an agent");
        }
        try {
            Why why = new Why(TraceReader.all(file));
            String from = agent == null ? "" : agent;
            List<String> answer = at == null ? why.answer(what, from) : why.at(at, from);
            answer.forEach(spec.commandLine().getOut()::println);
            return 0;
        } catch (MalformedEventException wrong) {
            throw new JavinoException(file + ": " + wrong.getMessage(), wrong);
        } catch (IllegalArgumentException wrong) {
            throw new JavinoException(wrong.getMessage(), wrong);
        }
    }
}
