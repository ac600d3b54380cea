package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import harness.AgentProcess;
import harness.Emulator;
import harness.Host;
import harness.InEmulatedTime;
import harness.Platform;
import harness.TestKeys;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import trace.TraceEvent;

/** Two agents of one MAS, in one Java virtual machine, each with a board of its own. */
@InEmulatedTime
class SeveralBoardsTest {

    private static final Map<String, Integer> HEADLIGHTS = Map.of("pin", 30);

    @Test
    @Tag("verify")
    void twoAgentsOfOneMas_talkByRadioAndWithoutAndHaveOnlyTheirOwnBoards(@TempDir Path folder) throws Exception {
        run(Platform.USUAL, folder);
    }

    static void run(Platform platform, Path folder) throws Exception {
        Emulator.Scenario scenario = new Emulator.Scenario()
                .board("scout", "Vehicle", light(List.of(List.of(0, 100))))
                .board("base", "Vehicle", light(List.of(List.of(0, 900), List.of(3, 900), List.of(3.00001, 950))))
                .fault(Map.of("t", 1, "board", "scout", "do", "unplug", "after", HEADLIGHTS));
        try (Emulator emulator = scenario.start(folder)) {
            Host.of(emulator, "scout").as("ROMA", Map.of("SUPO", TestKeys.PAIR)).close();
            Host.of(emulator, "base").as("SUPO", Map.of("ROMA", TestKeys.PAIR)).close();
            try (AgentProcess agents = AgentProcess.start(platform, "pair", List.of("scout", "base"), folder)) {
                for (String line : List.of("[base] dark by radio from ROMA", "[scout] delivered",
                        "[scout] understood, says base",
                        "[scout] thanks by radio from SUPO", "[scout] port off", "[base] light 950")) {
                    agents.await(line);
                }
                assertEquals(List.of("[scout] light 100"), said(agents, "[scout] light"));
                assertEquals("[base] light 900", said(agents, "[base] light").get(0));
                assertEquals(List.of("[base] port on"), said(agents, "[base] port"));
                assertOnAir(emulator, "scout", "SUPO");
                assertOnAir(emulator, "base", "ROMA");
            }
        }
    }

    /** The light that an LDR sees; a change comes after the board has switched its headlights on. */
    private static Map<String, Object> light(List<List<Number>> series) {
        return Map.of("sensors", List.of(Map.of("type", "ldr", "pin", "A0", "light", series, "after", HEADLIGHTS)));
    }

    private static List<String> said(AgentProcess agents, String beginning) {
        return agents.lines().stream().filter(line -> line.startsWith(beginning)).toList();
    }

    /**
     * A board was given one message, the one for the other; and all that it sent of it, maybe more than once, is
     * sealed.
     */
    private static void assertOnAir(Emulator emulator, String board, String destination) {
        assertEquals(List.of(destination), emulator.trace().stream().filter(event -> event.is("host-transmit", board))
                .map(event -> event.text("destination")).toList());
        List<TraceEvent> messages = emulator.sentBy(board).stream()
                .filter(event -> !event.text("kind").equals("acknowledgement")).toList();
        assertTrue(messages.stream().allMatch(event -> event.text("destination").equals(destination)
                && event.text("sealed").equals("true")), messages::toString);
    }
}
