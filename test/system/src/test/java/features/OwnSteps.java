package features;

import com.google.gson.JsonParser;
import harness.EmulatedRun;
import harness.Emulator;
import io.cucumber.java.After;
import io.cucumber.java.en.Given;
import io.cucumber.java.en.Then;
import io.cucumber.java.en.When;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Supplier;
import java.util.stream.IntStream;

/** What features of our own need beside the steps of all users. The model replays the trace of each scenario. */
public final class OwnSteps {

    private static final int BEHIND_THE_RUN = 1;

    /** Null where a scenario has none of these robots, as those of others. */
    private Path folder;

    @After(order = BEHIND_THE_RUN)
    public void replay() throws IOException {
        if (folder != null) {
            Emulator.check(folder.resolve("trace.jsonl"), folder.resolve("keys"), "features");
        }
    }

    /** A board with a sketch of ours, an agent of test/system or the one that does what it is told, and a sensor. */
    @Given("^a robot with (\\w+)(?: on an? (\\w+))?(?:, by the agent (\\w+))?(?:, that senses (.*))?$")
    public void robot(String sketch, String model, String agent, String sensor) throws IOException {
        Run run = Run.before();
        folder = run.folder;
        run.seed = EmulatedRun.current() == null ? run.seed : EmulatedRun.current().seed();
        Map<String, Object> more = new TreeMap<>();
        if (model != null) {
            more.put("model", model);
        }
        if (sensor != null) {
            more.put("sensors", List.of(JsonParser.parseString(sensor)));
        }
        new BoardSteps().boards(new Emulator.Scenario().board("robot", sketch, more).write(folder).toString());
        new AgentSteps().agents(Files.writeString(folder.resolve("robot.mas2j"),
                "MAS robot { agents: robot %s.asl agentArchClass diffuser.Diffuser; aslSourcePath: \"%s\"; }".formatted(
                        agent == null ? "robot" : agent,
                        Path.of(System.getProperty("javino.root"), "test/system/src/test/resources/agents")))
                .toString());
    }

    /** Its bytes are those of the text. */
    @When("an attacker sends the packet {word}")
    public void sends(String text) {
        Run.now().command(Map.of("do", "send", "position", List.of(0, 0), "payload",
                HexFormat.of().formatHex(text.getBytes(StandardCharsets.US_ASCII))));
    }

    /** All lines that begin with those words, in their order since the agents began, and how each of them goes on. */
    @Then("{agent} has printed {string}: {}")
    public void hasPrinted(String agent, String words, String rests) {
        List<String> expected = rests.equals("nothing") ? List.of() : List.of(rests.split(", "));
        Supplier<List<String>> printed = () -> Run.now().account.since(0).stream()
                .filter(each -> each.is(Seen.Kind.PRINTS, agent)).map(Seen::what)
                .filter(line -> line.startsWith(words + " ")).toList();
        Run.now().expected.now(() -> begin(printed.get(), expected.stream().map(rest -> words + " " + rest).toList()),
                () -> "it has printed " + printed.get());
    }

    private static boolean begin(List<String> lines, List<String> beginnings) {
        return lines.size() == beginnings.size()
                && IntStream.range(0, lines.size()).allMatch(i -> lines.get(i).startsWith(beginnings.get(i)));
    }
}
