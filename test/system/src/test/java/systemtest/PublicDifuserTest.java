package systemtest;

import harness.AgentProcess;
import harness.Emulator;
import harness.Host;
import harness.InEmulatedTime;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Agents as they are written for the public Difuser architecture. */
@InEmulatedTime
class PublicDifuserTest {

    @Test
    @Tag("verify")
    void twoAgents_transmitAndAcknowledgeByRadio(@TempDir Path folder) throws Exception {
        try (Emulator emulator =
                new Emulator.Scenario().board("bus", "Vehicle").board("police", "Station").start(folder)) {
            Host.of(emulator, "bus").as("ROMA", Map.of()).close();
            Host.of(emulator, "police").as("SUPO", Map.of()).close();
            try (AgentProcess receiver = AgentProcess.start("receiver", "jason.Difuser", folder)) {
                receiver.await("listens");
                try (AgentProcess transmitter = AgentProcess.start("transmitter", "Difuser", folder)) {
                    receiver.await("message 2");
                    transmitter.await("ack 2");
                    receiver.await("message 1");
                    transmitter.await("ack 1");
                    transmitter.await("end of transmission");
                }
            }
        }
    }

    @Test
    void sketchWithTheOlderLibrary_isGivenTheMessageAsAnAction(@TempDir Path folder) throws Exception {
        Emulator.Scenario scenario = new Emulator.Scenario().board("lamp", "OlderBoard",
                Map.of("watch", List.of(Map.of("pin", 13, "name", "led"))));
        try (Emulator emulator = scenario.start(folder);
                AgentProcess agent = AgentProcess.start("difuser", "Difuser", folder)) {
            agent.await("the sketch was given 1 0.5");
            emulator.await("the LED", event -> event.is("pin", "lamp") && event.number("level") == 1);
        }
    }
}
