package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import harness.AgentProcess;
import harness.Emulator;
import harness.Host;
import harness.InEmulatedTime;
import harness.TestKeys;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import trace.TraceEvent;

/** One agent with several boards. */
@InEmulatedTime
class NamedBoardsTest {

    private static final int HEADLIGHTS = 30;
    private static final int LED = 13;
    private static final Map<String, Object> UNO =
            Map.of("model", "uno", "watch", List.of(Map.of("pin", LED, "name", "led")));
    private static final int BOARDS = 8;
    private static final double FIRST = 4;
    private static final double STEP = 0.3;
    private static final int CHANGES = 8;
    private static final double UNPLUGGED = 5.05;
    private static final double LATEST = 0.02;

    private static final String ROBOT = """
            !start.
            +!start <-
                .port("ports/body"); .port("ports/arm", arm); .percepts(open);
                .setMyRFId("ROMA"); .getRFMessages(open);
                arm(ledOn); .act(headlightsOn); .print("ready").

            +light(L)    <- .print("light ", L).
            +arm(led(S)) <- .print("arm's led is ", S).
            +led(S)      <- .print("led is ", S).
            -arm(led(_)) <- .print("arm is dark").
            +hello(S)    <- .print("heard ", S).

            +port("ports/arm", off) <- !ask; !replace.
            +!ask <- .act(arm(ledOff)); .print("asked in vain").
            -!ask[error(E)] <- .print("not asked: ", E).
            +!replace <- .port("ports/spare", arm); arm(ledOn); .wait(arm(led(on))); .print("replaced"); !swap.

            // The main board and the other one change their places.
            +!swap <-
                .port("ports/spare"); .port("ports/body", arm);
                .wait(led(_) & arm(light(_)));
                arm(headlightsOn); ledOn;
                .print("swapped");
                .send(rival, achieve, take).
            -!swap[error(E), error_msg(M)] <- .print("not swapped: ", E, M).
            """;
    private static final String RIVAL = """
            +!take <- .port("ports/body"); .print("asked").
            +port("ports/body", off) <- .kill_agent(robot).
            +port("ports/body", on) <-
                .port("ports/spare", arm); .percepts(open); .wait(arm(led(S))); .print("took ", S).
            """;

    @Test
    @Tag("verify")
    void namedBoard_unpluggedReplacedSwappedTakenByAnother_isAsTheMainOne(@TempDir Path folder) throws Exception {
        Emulator.Scenario scenario = new Emulator.Scenario()
                .board("body", "Vehicle", light(List.of(List.of(0, 300))))
                .board("arm", "RadioBlink", UNO).board("spare", "Blink", UNO).board("station", "Station");
        Files.writeString(folder.resolve("robot.asl"), ROBOT);
        Files.writeString(folder.resolve("rival.asl"), RIVAL);
        Files.writeString(folder.resolve("mas.mas2j"), """
                MAS mas { agents: robot agentArchClass diffuser.Diffuser; rival agentArchClass diffuser.Diffuser; }
                """);
        try (Emulator emulator = scenario.start(folder);
                Host station = Host.of(emulator, "station").as("SUPO", Map.of());
                AgentProcess agents = AgentProcess.run("mas", folder, line -> {})) {
            agents.await("[robot] ready");
            agents.await("[robot] arm's led is on");
            station.send("////", "tell;hello(1)");
            agents.await("[robot] heard 1");

            emulator.command(Map.of("do", "unplug", "board", "arm"));
            for (String line : List.of("[robot] arm is dark", "[robot] not asked: port_off", "[robot] replaced",
                    "[robot] swapped")) {
                agents.await(line);
            }
            assertEquals(2, lit(emulator, "body", HEADLIGHTS));
            assertEquals(1, lit(emulator, "arm", LED));
            assertEquals(2, lit(emulator, "spare", LED));
            // The radio of the board that is the main one no longer is closed.
            station.send("////", "tell;hello(2)");

            agents.await("[rival] took off");
            assertTrue(agents.lines().stream().noneMatch(line -> line.contains("heard 2")));
            assertSaid(agents, "the radio of the board arm stays closed", "ports/spare: agent robot (board arm) of this"
                    + " MAS has it; give each board a port of its own",
                    "ports/body: agent robot (board arm) of this MAS"
                            + " has it");
        }
    }

    private static void assertSaid(AgentProcess agents, String... all) {
        for (String words : all) {
            assertTrue(agents.lines().stream().anyMatch(line -> line.contains(words)),
                    () -> words + " is missing:\n" + String.join("\n", agents.lines()));
        }
    }

    private static long lit(Emulator emulator, String board, int pin) {
        return pins(emulator, board, pin).stream().filter(event -> event.number("level") == 1).count();
    }

    private static List<TraceEvent> pins(Emulator emulator, String board, int pin) {
        return emulator.trace().stream().filter(event -> event.is("pin", board) && event.number("pin") == pin).toList();
    }

    /** The light that an LDR sees; the pins that the test looks at are watched. */
    private static Map<String, Object> light(List<List<Number>> series) {
        return Map.of("sensors", List.of(Map.of("type", "ldr", "pin", "A0", "light", series)), "watch",
                List.of(Map.of("pin", HEADLIGHTS, "name", "headlights")));
    }

    // ---- An agent that moves.

    private static final String WALKER = """
            !start.
            +!start <-
                .port("ports/home"); .port("ports/arm", arm); .port("ports/nowhere", leg);
                .setMyRFId("SUSS"); .getRFMessages(open);
                .send(rival, achieve, take); !!kick; !leave.
            +!kick <- .act(leg(kick)).
            -!kick[error(E)]  <- .print("cannot kick: ", E); !leave.
            +!leave <- .moveOut("SUBB", predation); .print("arrived").
            -!leave[error(E)] <- .print("cannot leave: ", E).
            """;

    @Test
    void agentWithNamedBoards_moves_leavesThemAndNotWhileAnActionWaits(@TempDir Path folder) throws Exception {
        Emulator.Scenario scenario = new Emulator.Scenario().board("home", "Station").board("away", "Station")
                .board("arm", "Blink", UNO).board("spare", "Blink", UNO);
        Path home = Files.createDirectories(folder.resolve("mas"));
        Path away = Files.createDirectories(folder.resolve("other"));
        Files.writeString(home.resolve("mas.mas2j"), """
                MAS mas { agents: robot [moves="%s"] agentArchClass mobility.Mobile agentArchClass diffuser.Diffuser;
                    rival agentArchClass diffuser.Diffuser; }
                """.formatted(home.resolve("moves")));
        Files.writeString(home.resolve("robot.asl"), WALKER);
        Files.writeString(home.resolve("rival.asl"), """
                +!take <- .port("ports/arm").
                +port("ports/arm", S) <- .print("the arm is ", S).
                """);
        Files.writeString(away.resolve("other.mas2j"), "MAS other { agents: door [moves=\"%s\"] %s; }"
                .formatted(away.resolve("moves"), "agentArchClass diffuser.Diffuser"));
        Files.writeString(away.resolve("door.asl"), """
                !start.
                +!start <- .port("ports/away"); .port("ports/spare", arm); .setMyRFId("SUBB"); .getRFMessages(open).
                +!moveIn(_, predation)[cast(unicast, From)] : .term2string(From, "SUSS").
                """);
        try (Emulator emulator = scenario.start(folder)) {
            Host.of(emulator, "home").as("SUSS", Map.of("SUBB", TestKeys.PAIR)).close();
            Host.of(emulator, "away").as("SUBB", Map.of("SUSS", TestKeys.PAIR)).close();
            try (AgentProcess others = AgentProcess.run("other", away, line -> {});
                    AgentProcess agents = AgentProcess.run("mas", home, line -> {})) {
                for (String line : List.of("[rival] the arm is off", "[robot] cannot leave: cannot_travel",
                        "[robot] cannot kick: port_off", "[rival] the arm is on")) {
                    agents.await(line);
                }
                // It lives on in the agent with the board, and does not know the other boards there.
                others.await("[door] arrived");
                emulator.await("the end of a board's port",
                        event -> event.is("port", "spare") && event.text("state").equals("closed"));
            }
        }
    }

    // ---- Eight boards, one unplugged.

    /** Each change of a board's light switches its headlights. */
    @Test
    void oneOfEightBoards_unplugged_othersPerceptsAreNotLate(@TempDir Path folder) throws Exception {
        List<List<Double>> all = reactions(Files.createDirectories(folder.resolve("all")), false);
        List<List<Double>> others = reactions(Files.createDirectories(folder.resolve("others")), true);
        for (int board = 0; board < BOARDS - 1; board++) {
            assertEquals(CHANGES, others.get(board).size());
            for (int i = 0; i < CHANGES; i++) {
                double late = others.get(board).get(i) - all.get(board).get(i);
                assertTrue(late <= LATEST, "board " + board + ", change " + i + ": " + late + " s");
            }
        }
    }

    /** When each board has shown each change of its light. */
    private static List<List<Double>> reactions(Path folder, boolean unplugging) throws Exception {
        Emulator.Scenario scenario = new Emulator.Scenario();
        StringBuilder program = new StringBuilder("!start.\n+!start <- .port(\"ports/b0\"); .percepts(open)");
        for (int board = 0; board < BOARDS; board++) {
            scenario.board("b" + board, "Vehicle", light(steps(FIRST + 0.03 * board)));
            program.append(board == 0 ? "" : "; .port(\"ports/b" + board + "\", b" + board + ")");
        }
        program.append("; .print(\"ready\").\n+light(L) : L < 500 <- headlightsOn.\n+light(_) <- headlightsOff.\n");
        for (int board = 1; board < BOARDS; board++) {
            program.append("""
                    +b%1$d(light(L)) : L < 500 <- b%1$d(headlightsOn).
                    +b%1$d(light(_)) <- b%1$d(headlightsOff).
                    """.formatted(board));
        }
        if (unplugging) {
            scenario.fault(UNPLUGGED, "b" + (BOARDS - 1), "unplug");
        }
        Files.writeString(folder.resolve("many.asl"), program);
        try (Emulator emulator = scenario.start(folder);
                AgentProcess agents = AgentProcess.run("many", folder, List.of())) {
            agents.await("[many] ready");
            Host.pause(FIRST + STEP * (CHANGES + 2));
            List<List<Double>> reactions = new ArrayList<>();
            for (int board = 0; board < BOARDS; board++) {
                reactions.add(pins(emulator, "b" + board, HEADLIGHTS).stream().map(TraceEvent::seconds).toList());
            }
            return reactions;
        }
    }

    private static List<List<Number>> steps(double first) {
        List<List<Number>> series = new ArrayList<>(List.of(List.of(0, 900)));
        IntStream.range(0, CHANGES).forEach(i -> {
            double t = first + STEP * i;
            series.add(List.of(t, i % 2 == 0 ? 900 : 100));
            series.add(List.of(t + 0.00001, i % 2 == 0 ? 100 : 900));
        });
        return series;
    }
}
