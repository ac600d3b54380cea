package lockstep;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.jar.JarEntry;
import java.util.jar.JarFile;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Agents in the time of a simulation, without boards. */
class AgentProgramTest {

    private static final Path ROOT = Path.of(System.getProperty("javino.root"));

    @TempDir
    private Path folder;

    private Simulation start(long seed, Consumer<String> trace) throws IOException {
        Path scenario = Files.writeString(folder.resolve("scenario.json"), """
                {"boards": [{"name": "board", "firmware": "%s", "port": "ports/board"}]}
                """.formatted(ROOT.resolve("javino-firmware/build/station/Station.ino.elf")));
        return Simulation.start(List.of(ROOT.resolve("emulator/build/javino-emulator").toString(),
                scenario.toString(), "--directory", folder.toString()), List.of("ports/board"), seed,
                Simulation.JITTER, folder.resolve("trace.jsonl"), trace);
    }

    private Simulation start(long seed) throws IOException {
        return start(seed, line -> {});
    }

    private AgentProgram program(Simulation simulation, String name, String plans, List<String> printed)
            throws IOException {
        Files.writeString(folder.resolve(name + ".asl"), plans);
        Path mas = Files.writeString(folder.resolve(name + ".mas2j"), "MAS %s { agents: %s; }".formatted(name, name));
        return AgentProgram.start(simulation, mas, printed::add);
    }

    /** All that a program prints within some emulated seconds. */
    private List<String> printed(long seed, String plans, int seconds) throws IOException {
        List<String> printed = new ArrayList<>();
        try (Simulation simulation = start(seed)) {
            AgentProgram program = program(simulation, "one", plans, printed);
            simulation.pause(Duration.ofSeconds(seconds).toNanos());
            program.close();
        }
        return printed;
    }

    @Test
    void timesAndDates_areThoseOfTheSimulation() throws Exception {
        List<String> printed = printed(1, """
                !start.
                +!start <- .date(Y, M, D); .time(H, Min, _); .print(Y, "-", M, "-", D, " ", H, ":", Min);
                    .nano_time(N); T = system.time; .wait(61000);
                    .print(math.round((system.time - T) / 1000)); .time(_, Later, _); .print(Later);
                    .nano_time(After); .print(math.round((After - N) / 1000000000)).
                """, 70);
        assertEquals(List.of("[one] 2027-1-1 12:0", "[one] 61", "[one] 1", "[one] 61"), printed);
    }

    @Test
    void dice_areThoseOfTheSeed() throws Exception {
        String plans = """
                !start.
                +!start <- .random(X); Y = math.random; .shuffle([1, 2, 3, 4, 5, 6, 7, 8], Z); .print(X, " ", Y);
                    .print(Z).
                """;
        List<String> first = printed(1, plans, 1);
        assertEquals(2, first.size(), first.toString());
        assertEquals(first, printed(1, plans, 1));
        List<String> others = printed(2, plans, 1);
        assertNotEquals(first.get(0), others.get(0));
        assertNotEquals(first.get(1), others.get(1));
    }

    /** All that a program does that is recorded or not. */
    private List<String> done(boolean recorded, List<String> lines) throws IOException {
        Files.writeString(folder.resolve("two.asl"), """
                n(0). n(1). n(2). !start.
                wide(X) :- n(X) & X > 0.
                +!start <- .port("ports/board"); .percepts(open); !count(3); !plans; !!late; !!outer; .wait(200);
                    !never; +end.
                -!never[error(E)] <- .print("failed ", E).
                +!count(N) : N > 0 & n(X) & .print("asked ", X) & X > 1
                    <- .print(N, X); .random(R); .print(R); !count(N-1).
                +!count(N) : not N > 0 & .findall(X, wide(X), L) <- .print(L).
                +!count(N) : n(N) <- .print("else ", N); !count(N-1).
                +!outer <- !within(1); .act(blink). { +!within(X) : n(Y) & Y > X + 7 <- .print(Y). }
                @l +!plans : n(X) & X > 1 | wide(9) <- .add_plan({+!late : n(Y) & Y > 7 <- .print(Y)}, x);
                    .add_plan({+!late : n(Y) & Y > 7 <- .print(Y)}, y); .add_plan({+!late : n(1) <- .print(late)}, x);
                    .relevant_plans({+!late}, P); .print(P); .relevant_plans({+!count(_)}, Q); .print(Q);
                    .plan_label(O, l); .print(O); .list_plans.
                +port(_, on) <- .drop_desire(count(_)); .print(on).
                +end : .count(n(_), C) & C == 3 <- .abolish(n(_)); .print(end).
                """);
        Path mas = Files.writeString(folder.resolve("two.mas2j"),
                "MAS two { agents: two agentArchClass diffuser.Diffuser; }");
        List<String> done = new ArrayList<>();
        try (Simulation simulation = start(3, done::add)) {
            AgentProgram program = AgentProgram.observe(simulation, mas, new AgentProgram.Observer() {
                @Override
                public void printed(String agent, String line) {
                    done.add(line.replaceAll("p__\\d+", "p"));
                }

                @Override
                public void believes(String agent, String belief, boolean added) {
                    done.add(simulation.nanos() + (added ? " +" : " -") + belief);
                }

                @Override
                public void recorded(Supplier<String> line) {
                    lines.add(line.get());
                }

                @Override
                public boolean records() {
                    return recorded;
                }
            });
            simulation.pause(Duration.ofSeconds(3).toNanos());
            program.close();
        }
        return done;
    }

    @Test
    void program_thatIsRecorded_doesTheSame() throws Exception {
        List<String> lines = new ArrayList<>();
        List<String> alone = done(false, lines);
        assertEquals(List.of(), lines);
        assertEquals(String.join("\n", alone), String.join("\n", done(true, lines)));
        assertTrue(alone.stream().filter(line -> line.startsWith("asked ")).count() > 8, alone.toString());
        assertTrue(alone.stream().anyMatch(line -> line.contains("\"event\":\"host-nothing\"")), alone.toString());
        for (String part : List.of("\"part\":\"N > 0\",\"values\":[\"N = 0\"]", "\"part\":\"Y > 7\",\"values\":[\"Y = ",
                "\"step\":\"!never\"", "\"event\":\"agent-settings\"",
                "\"part\":\"Y > (X+7)\",\"values\":[\"X = 1, Y = ")) {
            assertTrue(lines.stream().anyMatch(line -> line.contains(part)), part + String.join("\n", lines));
        }
    }

    /** A newer Jason may ask for them elsewhere, too. */
    @Test
    void jasonsLibrary_asksJavaForTimeAndChanceWhereItIsPatched() throws Exception {
        Pattern asks = Pattern.compile("currentTimeMillis|nanoTime|java/util/(Random|Date|Calendar|Timer)\\W"
                + "|GregorianCalendar|java/lang/Math\\W.*\0\6random|\0\7shuffle|java/time/|randomUUID"
                + "|ThreadLocalRandom|SecureRandom|concurrent/Executors|java/lang/Thread\\W.*\0\5(sleep|start)",
                Pattern.DOTALL);
        Set<String> asking = new TreeSet<>();
        try (JarFile jason = new JarFile(Path.of(jason.asSemantics.Agent.class.getProtectionDomain().getCodeSource()
                .getLocation().toURI()).toFile())) {
            for (JarEntry entry : Collections.list(jason.entries())) {
                try (InputStream file = jason.getInputStream(entry)) {
                    if (entry.getName().matches("jason/(stdlib|functions)/.*[.]class")
                            && asks.matcher(new String(file.readAllBytes(), StandardCharsets.ISO_8859_1)).find()) {
                        asking.add(entry.getName().replaceFirst("[.]class$", "").replace('/', '.'));
                    }
                }
            }
        }
        assertEquals(new TreeSet<>(AgentProgram.ASKING), asking);
    }

    @Test
    void agents_areCreatedTalkAndAreKilled() throws Exception {
        Files.writeString(folder.resolve("child.asl"),
                "+hello[source(S)] <- .print(\"hello\"); .send(S, tell, hello).");
        List<String> printed = printed(1, """
                !start.
                +!start <- .create_agent(child, "child.asl"); .send(child, tell, hello).
                +hello[source(child)] <- .print("answered"); .kill_agent(child); .wait(1000); !again.
                +!again <- .send(child, tell, hello).
                -!again[error(E)] <- .print(E).
                """, 3);
        assertEquals(List.of("[child] hello", "[one] answered"), printed.subList(0, 2));
        assertTrue(printed.contains("[one] receiver_not_found"), printed.toString());
    }

    @Test
    void deadlineOfAWait_passesInEmulatedTime() throws Exception {
        List<String> printed = printed(1, """
                !start.
                +!start <- .wait(never, 5000, Passed); .print("waited ", math.round(Passed / 1000)).
                """, 6);
        assertEquals(List.of("[one] waited 5"), printed);
    }

    @Test
    void programs_haveAJasonEach() throws Exception {
        List<String> one = new ArrayList<>();
        List<String> other = new ArrayList<>();
        String plans = "!start. +!start <- .all_names(All); .print(All).";
        try (Simulation simulation = start(1)) {
            List<AgentProgram> both =
                    List.of(program(simulation, "one", plans, one), program(simulation, "other", plans, other));
            simulation.pause(1_000_000_000);
            both.forEach(AgentProgram::close);
        }
        assertEquals(List.of("[one] [one]"), one);
        assertEquals(List.of("[other] [other]"), other);
    }

    @Test
    void programThatIsKilled_doesNothingMore() throws Exception {
        List<String> printed = new ArrayList<>();
        try (Simulation simulation = start(1)) {
            AgentProgram program =
                    program(simulation, "one", "!count(0). +!count(N) <- .print(N); .wait(1000); !count(N + 1).",
                            printed);
            simulation.pause(Duration.ofMillis(2500).toNanos());
            program.kill();
            simulation.pause(Duration.ofSeconds(5).toNanos());
        }
        assertEquals(List.of("[one] 0", "[one] 1", "[one] 2"), printed);
    }

    /** Why a program does not start whose files have these texts; an empty one is missing. */
    private String failure(String mas, String agent) throws IOException {
        Path program = Files.writeString(folder.resolve("one.mas2j"), mas);
        if (!agent.isEmpty()) {
            Files.writeString(folder.resolve("one.asl"), agent);
        }
        try (Simulation simulation = start(1)) {
            return assertThrows(IOException.class, () -> AgentProgram.start(simulation, program, line -> {}))
                    .getMessage().replace(folder + "/", "");
        }
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', value = {
            "MAS one { agents: one; }         | ``                       | agent one cannot start: there is no file",
            "MAS one { agents: one; }         | `!start.\n+!start <- a b.` | one.asl:2: b is not expected here",
            "MAS one { agents: one; }         | `!start.\n+!start <- .print(\"a).` | one.asl:2: ",
            "MAS one { agents one; }          | !start.                  | one.mas2j:1: one is not expected here",
            "MAS one { agents: one \"two; }    | !start.                  | one.mas2j:1: ",
            "MAS one { agents: one agentArchClass a.Missing; } | !start. |"
                    + " agent one cannot start: there is no class a.M",
            "MAS one { agents: one agentClass a.Missing; } | !start. | agent one cannot start: there is no class a.M",
            "MAS one { environment: a.Missing agents: one; } | !start.   | a.Missing"
    })
    void programThatCannotStart_saysWhereAndWhy(String mas, String agent, String expected) throws IOException {
        String failure = failure(mas, agent.replace("\\n", "\n"));
        assertTrue(failure.contains(expected), failure);
        assertEquals(1, failure.lines().count(), failure);
    }

    /** All that an observer is told. */
    private static final class Told implements AgentProgram.Observer {
        private final List<String> lines = new ArrayList<>();

        @Override
        public void printed(String agent, String line) {
            lines.add(agent + ": " + line);
        }

        @Override
        public void believes(String agent, String belief, boolean added) {
            lines.add(agent + (added ? " +" : " -") + belief);
        }
    }

    @Test
    void observer_isToldOfBeliefsThatLastForACycle() throws Exception {
        Told told = new Told();
        Files.writeString(folder.resolve("one.asl"), "+!go <- +a(1); -a(_); .print(gone); .wait(5000); .print(late).");
        Path mas = Files.writeString(folder.resolve("one.mas2j"), "MAS one { agents: one; }");
        try (Simulation simulation = start(1); AgentProgram program = AgentProgram.observe(simulation, mas, told)) {
            AgentProgram.Agents agents = program.agents();
            assertEquals(Set.of("one"), agents.agents());
            agents.give("one", "+!go");
            assertEquals("its plans go on", agents.busy("one"));
            simulation.pause(1_000_000_000);
            assertEquals("", agents.busy("one"));
            agents.give("one", "+b");
            assertThrows(IOException.class, () -> agents.give("one", "go("));
            simulation.pause(1_000_000_000);
        }
        assertEquals(List.of("one +a(1)[source(self)]", "one -a(1)[source(self)]", "one: gone", "one +b[source(self)]"),
                told.lines);
    }
}
