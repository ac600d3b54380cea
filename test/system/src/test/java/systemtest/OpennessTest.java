package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import harness.AgentProcess;
import harness.Emulator;
import harness.InEmulatedTime;
import harness.Transmitter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** An agent that knows how open its MAS is, by a real board's radio. */
@InEmulatedTime
class OpennessTest {

    @Test
    @Tag("verify")
    void boardGoesAndComes_agentGoesThroughAllTransitionsOfFigureOne(@TempDir Path folder) throws Exception {
        try (Emulator emulator = new Emulator.Scenario().board("antenna", "Vehicle").start(folder);
                AgentProcess agent = AgentProcess.start("wanderer", folder)) {
            agent.await("openness open");
            emulator.command(Map.of("do", "unplug", "board", "antenna"));
            agent.await("openness limitedOpen", 2);
            emulator.command(Map.of("do", "plug", "board", "antenna"));
            agent.await("openness closed", 2);
            emulator.command(Map.of("do", "unplug", "board", "antenna"));
            agent.await("openness totallyClosed", 3);
            assertEquals(List.of(
                    "totallyClosed",
                    "closed",         // +com: the board has come
                    "open",           // +mob
                    "limitedOpen",    // -com: the board is unplugged
                    "totallyClosed",  // -mob
                    "limitedOpen",    // +mob
                    "open",           // +com: the board is back
                    "closed",         // -mob
                    "totallyClosed"), // -com: the board is unplugged again
                    openness(agent));
        }
    }

    /** Definitions 2 to 5, by a real radio by which agents can move as soon as a plan admits them. */
    @Test
    void radioOpensAndAPlanAdmits_agentSeesTheFourKindsOfTableOne(@TempDir Path folder) throws Exception {
        try (Emulator emulator = new Emulator.Scenario().board("antenna", "Vehicle").start(folder);
                AgentProcess agent = AgentProcess.start("harbour", folder)) {
            agent.await("openness limitedOpen");
            assertEquals(List.of(
                    "totallyClosed",
                    "closed",         // +com: the radio is open
                    "open",           // +mob: a plan admits
                    "totallyClosed",  // -com, -mob: the radio is blocked
                    "limitedOpen"),   // +mob: another way to move
                    openness(agent));
            assertTrue(emulator.process().isAlive(), "the board was there all the time");
        }
    }

    @Test
    void radioHearsNobodyAndThenAPacketForAnother_communicabilityIsLostAndRestored(@TempDir Path folder)
            throws Exception {
        try (Emulator emulator =
                new Emulator.Scenario().board("antenna", "Vehicle").board("other", "Transmitter").start(folder);
                Transmitter other = Transmitter.of(emulator, "other");
                AgentProcess agent = AgentProcess.start("listener", folder)) {
            agent.await("openness totallyClosed", 2);
            other.send("ROMACAFFBotell;hello(1)".getBytes(StandardCharsets.US_ASCII));
            agent.await("openness totallyClosed", 3);
            assertEquals(List.of("totallyClosed", "closed", "totallyClosed", "closed", "totallyClosed"),
                    openness(agent));
        }
    }

    private static List<String> openness(AgentProcess agent) {
        return agent.lines().stream().filter(line -> line.contains("openness "))
                .map(line -> line.substring(line.indexOf("openness ") + "openness ".length())).toList();
    }
}
