package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;

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

/** An agent whose board goes and comes. */
@InEmulatedTime
class RecoveryTest {

    private static final Map<String, Object> SENSORS =
            Map.of("sensors", List.of(Map.of("type", "ldr", "pin", "A0", "light", List.of(List.of(0, 300)))));

    @Test
    void resetBoard_isSeenAndTheAgentGoesOn(@TempDir Path folder) throws Exception {
        comesBack(folder, "reset");
    }

    @Test
    @Tag("verify")
    void unpluggedBoard_isSeenAndTheAgentGoesOn(@TempDir Path folder) throws Exception {
        comesBack(folder, "unplug", "plug");
    }

    private static void comesBack(Path folder, String... faults) throws Exception {
        Emulator.Scenario scenario =
                new Emulator.Scenario().board("lamp", "Vehicle", SENSORS).board("other", "Transmitter");
        try (Emulator emulator = scenario.start(folder);
                Transmitter other = Transmitter.of(emulator, "other");
                AgentProcess agent = AgentProcess.start("watcher", folder)) {
            agent.await("answered");
            agent.await("light 300");
            agent.await("ready");

            for (String fault : faults) {
                emulator.command(Map.of("do", fault, "board", "lamp"));
                agent.await("port off");
            }
            agent.await("port on", 2);
            agent.await("answered", 2);
            other.send("////CAFFBotell;hello(1)".getBytes(StandardCharsets.US_ASCII));
            agent.await("message 1 from CAFF");

            List<String> ports = agent.lines().stream().filter(line -> line.contains("port o"))
                    .map(line -> line.substring(line.indexOf("port"))).toList();
            assertEquals(List.of("port on", "port off", "port on"), ports);
        }
    }
}
