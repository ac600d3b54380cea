package features;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Features as a user writes them, played by Cucumber's own program on a board with the example Blink. */
class FeaturesTest {

    private static final String AGENT = """
            !start.
            +!start <- .port("ports/robot"); .percepts(open); .act(ledOn); .wait(1000); .act(ledOff).
            +!blink(N) : N > 0 <- .act(ledOn); .act(ledOff); .print("blink ", N); !blink(N - 1).
            +!blink(0).
            +!wrong <- .act(ledOm).
            +dark <- .wait(700); .act(ledOn).
            +brightness(B) <- .print(B).
            """;

    @AutoClose
    private final Project project;

    FeaturesTest(@TempDir Path folder) throws IOException {
        project = new Project(folder, "blink/Blink", AGENT);
    }

    private int play(String steps) throws IOException {
        return project.play(steps);
    }

    /** The beginning is at the plan's wait, with the lamp lit. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', value = {
            "Then robot's lamp is on / And robot's 13 is high / And its pin A3 is off / "
                    + "And within 1100 ms its lamp is off",
            "When 100 ms pass / Then the agent robot still believes led(on) / "
                    + "And it does not believe led(off) / And it no longer believes led(_)",
            "When 1500 ms pass / And the agent robot gets the goal blink(3) / Then it prints \"blink 1\" / "
                    + "And within 1 s robot's lamp is on exactly 3 times / And it performs ledOff exactly 3 times / "
                    + "And it believes led(off) at most 100 a second",
            "When the agent robot gets the goal wrong / Then it fails to perform ledOm with unknown_action",
            "When the agent robot gets the belief dark / Then it believes dark[source(self)] / "
                    + "And not within 600 ms it performs ledOn / And within 800 ms it performs ledOn / "
                    + "When it loses the belief dark / Then within 100 ms it no longer believes dark",
            "When 100 ms pass / And robot's board is unplugged for 3 s / "
                    + "Then the agent robot no longer believes led(_) / "
                    + "And within 2 s of its return the agent robot believes port(_, on)",
            "When robot's board is reset / Then robot's lamp is off",
            "When robot's board has no power for 500 ms / "
                    + "Then within 2 s of its return the agent robot believes led(off)",
            "When the button at robot's 2 is pressed for 20 ms / And 2 s pass / Then never robot's lamp is on",
            "Given the seed 7 / When the level at robot's 2 falls to 0 / "
                    + "Then not within 1 s the agent robot prints \"a\"",
            "When 1500 ms pass / Then within 0.1 s the agent robot performs ledOff exactly 0 times",
    })
    void steps_whatIsSo_pass(String steps) throws IOException {
        assertEquals(0, play(steps), project.said());
        assertTrue(project.said().contains("scenarios: 1 passed"), project.said());
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', value = {
            "Then robot's lamp is off|robot's lamp is on",
            "Then within 500 ms robot's lamp is on|robot's lamp does not go on; it is on all the time",
            "Then within 500 ms robot's lamp is off|robot's lamp does not go off",
            "Then not within 2 s robot's lamp is off|it happens at 1.",
            "Then never robot's lamp is off|it happens at 1.",
            "When the agent robot gets the belief dark / Then within 1 s it performs ledOn / "
                    + "And within 100 ms it performs ledOn|robot does not perform ledOn",
            "When 1500 ms pass / Then within 1 s robot's lamp is off|it is off all the time",
            "When 100 ms pass / Then robot's lamp is off|  on: robot's lamp",
            "When 1500 ms pass / Then never robot's lamp is on / When the agent robot gets the goal blink(1) / "
                    + "Then it prints \"blink 1\"|it happens at",
            "When 100 ms pass / Then within 500 ms the agent robot believes led(on)|it has believed it all the time",
            "Then the agent robot believes brightness(3)|robot has plans for what it has never believed: "
                    + "+brightness/1 (robot.asl:7), +dark/0 (robot.asl:6)",
            "When the agent robot gets the goal blink(3) / Then it performs ledOn exactly 2 times|seen 3 times",
            "When the agent robot gets the goal blink(3) / "
                    + "Then it performs ledOn at most 2 a second|seen 3 times within",
            "When the agent robot gets the goal wrong / Then it performs ledOm|has not performed ledOm: unknown_action",
            "When the agent robot gets the goal wrong / Then it performs ledOm|"
                    + "    first cause: robot's board refused ledOm: unknown_action",
            "Then the agent robot believes lde(on)|first cause: robot never believed lde(on); the nearest is led(on)",
            "When the agent robot gets the goal wrong / Then it fails to perform ledOm with port_off|does not fail",
            "When the light at robot's A0 falls to 1|expected the pin of a sensor of this board",
            "When the light at robot's 2 falls to 0|"
                    + "the sensor at robot's pin 2 has the type digital in board.json, not ldr",
            "Then not within 100 ms the counter radioBadTags of the agent robot rises|"
                    + "there is no counter radioBadTags",
            "Then it prints \"a\" / Senario: c|the features cannot be played: Failed to parse",
            "When bus's board is reset|has no board bus; it has robot",
            "Then the agent bus prints \"a\"|has no agent bus; it has robot",
            "Then it prints \"a\"|no agent was named before",
            "Then robot's motor is on|board.json watches no pin motor of robot",
            "Then within 1 s of its return the agent robot prints \"a\"|nothing was taken away that could return",
            "Then the agent robot believes led(|led( is no term of AgentSpeak",
            "When the agent robot gets the goal x( / Then it prints \"a\"|+!x( is no goal or belief",
            "Then robot's lamp is on / Given the seed 3|are chosen before the first other step",
            "Given the agents of \"other.mas2j\" / Then the agent robot prints \"a\"|cannot start: there is no file ",
            "Given the boards of \"other.json\" / "
                    + "Then the agent robot prints \"a\"|cannot start: there is no file other.json",
            "Then I like it|no step has these words",
    })
    void steps_whatIsNotSo_failAndSayWhatWasSeen(String steps, String expected) throws IOException {
        assertEquals(1, play(steps), project.said());
        assertTrue(project.said().contains(expected), project.said());
        assertFalse(project.said().contains("\tat "), project.said());
    }

    @ParameterizedTest
    @ValueSource(strings = {"nowhere.feature", "nowhere.feature:3", "robot.asl", "."})
    void play_ofNoFeature_fails(String file) {
        assertEquals(1, Play.run("--glue", "features", "--no-summary", "--plugin", "features.Report",
                project.folder().resolve(file).toString()));
    }

    /** Agents of Jason in a virtual machine of their own: what is so, and what is not. */
    @Test
    void realTime_isTheSameFromTheAgentsSide() throws IOException {
        project.inRealTime();
        assertEquals(0, play("When 1500 ms pass / And the agent robot gets the goal blink(2) / "
                + "Then within 60 s it prints \"blink 1\" / And within 60 s robot's lamp is off / "
                + "When it gets the belief dark / Then within 60 s it believes dark[source(self)] / "
                + "And within 60 s it performs ledOn / And robot's lamp is on / "
                + "When it gets the goal wrong / Then within 60 s it fails to perform ledOm with unknown_action / "
                + "When its board is unplugged for 500 ms / Then within 60 s it believes port(_, off) / "
                + "And within 60 s of its return it believes port(_, on) / "
                + "And within 60 s the counter serialRequests of it rises"), project.said());
        assertEquals(1, play("When the agent robot gets the goal wrong / Then never it prints \"a\" / "
                + "And within 4 s it performs ledOm"), project.said());
        for (String told : List.of("has not performed ledOm: unknown_action", "robot does not perform ledOm",
                "robot has plans for what it has never believed: +brightness/1 (robot.asl:7), +dark/0 (robot.asl:6)")) {
            assertTrue(project.said().contains(told), project.said());
        }
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', value = {
            "robot.asl|!start.|!start|robot.asl:2: ",
            "robot.mas2j|diffuser.Diffuser|diffuser.Difuser|"
                    + "agent robot cannot start: there is no class diffuser.Difuser",
            "board.json|\"digital\"|\"digit\"|digit",
    })
    void realTime_programThatCannotStart_failsWithItsPlace(String file, String old, String wrong, String expected)
            throws IOException {
        project.inRealTime();
        Path changed = project.folder().resolve(file);
        Files.writeString(changed, Files.readString(changed).replace(old, wrong));
        assertEquals(1, play("Then the agent robot prints \"a\""), project.said());
        assertTrue(project.said().contains("the scenario cannot start: ") && project.said().contains(expected),
                project.said());
    }

    /** Nobody is at the terminal, and no board at the port. */
    @Test
    void realBoard_whatNobodyDoesOrSees_isListed() throws IOException {
        project.inRealTime();
        System.setProperty("javino.port", "/dev/null");
        InputStream terminal = System.in;
        System.setIn(InputStream.nullInputStream());
        try {
            assertEquals(0, play("Then within 1 s robot's lamp is on / And the agent robot does not believe led(on) / "
                    + "When the level at robot's 2 falls to 0 / Then it prints \"a\""), project.said());
            assertTrue(project.said().contains("  make that so at the board, then press Enter"), project.said());
            assertTrue(project.said().endsWith("""
                    scenarios: 1 skipped
                    not checked on the real board:
                      a.feature:4  Then within 1 s robot's lamp is on
                      a.feature:6  When the level at robot's 2 falls to 0
                    """), project.said());
            assertEquals("1 skipped; steps not checked: 2\n",
                    Files.readString(project.folder().resolve("runs/real-board.txt")));
            assertEquals(0, play("Given the device SUPO / Then the agent robot prints \"a\""), project.said());
            assertEquals(1, play("Then within 100 ms the agent robot believes led(on)"), project.said());
            System.setProperty("javino.port", "/dev/there_is_none");
            assertEquals(1, play("Then the agent robot prints \"a\""), project.said());
            assertTrue(project.said().contains("there is no file /dev/there_is_none"), project.said());
        } finally {
            System.setIn(terminal);
        }
    }

    @Test
    void pin_ofAnalogWrite_hasItsDuty(@TempDir Path folder) throws IOException {
        String agent = "!start. +!start <- .port(\"ports/robot\"). +!go <- .act(forward). +!halt <- .act(halt).";
        String go = "When the agent robot gets the goal go / Then within 1 s robot's pin 5 is at ";
        try (Project car = new Project(folder, "linefollower/LineFollower", agent)) {
            assertEquals(0, car.play(go + "59 % / And within 1 s its pin 6 is at 59 % / And its pin 5 is at 59 % / "
                    + "When it gets the goal halt / Then within 1 s its pin 5 is off"), car.said());
            assertEquals(1, car.play(go + "60 %"), car.said());
            assertTrue(car.said().contains("robot's pin 5 does not go to 60 %"), car.said());
            assertTrue(car.said().contains("  on: robot's pin 5 at 59 %, robot's pin 6 at 59 %"), car.said());
        }
    }

    @Test
    void servo_isSeenByItsPulses(@TempDir Path folder) throws IOException {
        String agent = "!start. +!start <- .port(\"ports/robot\"). +!go(A) <- .act(turn(A),T); .print(by(T)). "
                + "-!go(A)[reason(R)] <- .print(R).";
        String go = "When the agent robot gets the goal go(120) / Then within 1 s the servo at robot's pin 9 is at ";
        try (Project arm = new Project(folder, "servo/Servo", agent)) {
            assertEquals(0, arm.play("Then the servo at robot's pin 9 is at 90 degrees / " + go + "120 degrees / "
                    + "Then within 1 s the agent robot prints \"by(30)\" / "
                    + "When 100 ms pass / Then the servo at its pin 9 is at 120 degrees / "
                    + "When it gets the goal go(200) / "
                    + "Then within 1 s it fails to perform turn(200) with action_failed / "
                    + "And within 1 s it prints \"beyond(180)\""), arm.said());
            assertEquals(1, arm.play(go + "90 degrees"), arm.said());
            assertTrue(arm.said().contains("the servo at robot's pin 9 does not turn to 90 degrees"), arm.said());
            assertTrue(arm.said().contains("robot's servo at pin 9 turns to 1"), arm.said());
            assertFalse(arm.said().contains("robot's pin 9 goes"), arm.said());
        }
    }

    @Test
    void failure_saysWhereWhenAndHowToRepeatIt() throws IOException {
        System.setProperty("javino.seed", "5");
        assertEquals(1, play("Then within 500 ms robot's lamp is off"), project.said());
        List<String> told = project.said().lines().toList();
        assertEquals("a.feature:4  Then within 500 ms robot's lamp is off", told.get(0), project.said());
        assertTrue(told.get(1).matches("  at [\\d.]+ s: robot's lamp does not go off"), project.said());
        assertTrue(project.said().contains("  this runs it again: gradle test -Pfeature="), project.said());
        assertTrue(project.said().contains("a.feature:3 -Pseed=5\n"), project.said());
        Path trace = project.folder().resolve("runs/a-3/trace.jsonl");
        assertTrue(project.said().contains("javino watch --trace " + trace), project.said());
        assertTrue(Files.readString(trace).contains("\"name\":\"lamp\",\"level\":1"));
        assertTrue(Files.readString(project.folder().resolve("junit.xml")).contains("robot&#39;s lamp does not go off")
                || Files.readString(project.folder().resolve("junit.xml")).contains("robot's lamp does not go off"));
    }

    @Test
    void run_ofOneSeed_isTheSame() throws IOException {
        String steps = "When the agent robot gets the goal blink(5) / Then it prints \"blink 1\"";
        assertEquals(0, play(steps), project.said());
        Path trace = project.folder().resolve("runs/a-3/trace.jsonl");
        String first = Files.readString(trace);
        assertEquals(0, play(steps), project.said());
        assertEquals(first, Files.readString(trace));
        assertEquals(0, play("Given the seed 2 / " + steps), project.said());
        assertFalse(first.equals(Files.readString(trace)));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', value = {
            "robot.asl|+!start <- .port(\"a\").|+!start <- .port(\"a\"|robot.asl:2: ",
            "robot.mas2j|agents:|agents|robot.mas2j:1: ",
            "robot.mas2j|diffuser.Diffuser|diffuser.Difuser|"
                    + "agent robot cannot start: there is no class diffuser.Difuser",
            "robot.mas2j|agents: robot|agents: bus|agent bus cannot start: there is no file",
            "board.json|Blink.ino.elf|Other.ino.elf|Other.ino.elf",
            "board.json|digital|digit|digit",
            "board.json|\"boards\": [|\"boards\" [|board.json has not the form of a scenario",
    })
    void programThatCannotStart_failsWithItsPlace(String file, String old, String wrong, String expected)
            throws IOException {
        Files.writeString(project.folder().resolve("robot.asl"), "!start.\n+!start <- .port(\"a\").\n");
        Path changed = project.folder().resolve(file);
        Files.writeString(changed, Files.readString(changed).replace(old, wrong));
        assertEquals(1, play("Then the agent robot prints \"a\""), project.said());
        assertTrue(project.said().contains("the scenario cannot start: ") && project.said().contains(expected),
                project.said());
    }
}
