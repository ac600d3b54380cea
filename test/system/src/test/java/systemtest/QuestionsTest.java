package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import harness.AgentProcess;
import harness.Emulator;
import harness.Host;
import harness.InEmulatedTime;
import harness.TestKeys;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Two agents in two Java virtual machines, who ask, answer and teach each other over the air. */
@InEmulatedTime
class QuestionsTest {

    @Test
    @Tag("verify")
    void agentsAskEachOther_answersResumeWhoAskedAndNothingIsReadable(@TempDir Path folder) throws Exception {
        try (Emulator emulator =
                new Emulator.Scenario().board("bus", "Vehicle").board("police", "Station").start(folder)) {
            provision(emulator, "bus", "ROMA",
                    Map.of("SUPO", TestKeys.PAIR, "SUHO", TestKeys.PAIR, "//SU", TestKeys.GROUP));
            provision(emulator, "police", "SUPO", Map.of("ROMA", TestKeys.PAIR, "//SU", TestKeys.GROUP));
            try (AgentProcess police = AgentProcess.start("answerer", folder)) {
                police.await("listens");
                try (AgentProcess bus = AgentProcess.start("asker", folder)) {
                    bus.await("speed is 80");
                    bus.await("colour is false");
                    bus.await("near are 2");
                    bus.await("good \"morning\", asker");
                    police.await("la la \"la\", asker");
                    bus.await("SUHO does not answer: undelivered");
                    bus.await("in the group SUPO drives 80");
                }
            }
            assertFalse(sent(emulator).isEmpty());
            for (String text : List.of("speed", "near", "greet", "song")) {
                assertEquals(List.of(), sent(emulator).stream().filter(payload -> payload.contains(hex(text))).toList(),
                        text);
            }
        }
    }

    private static void provision(Emulator emulator, String board, String id, Map<String, byte[]> keys) {
        Host.of(emulator, board).as(id, keys).close();
    }

    private static List<String> sent(Emulator emulator) {
        return Stream.of("bus", "police").flatMap(board -> emulator.sentBy(board).stream())
                .map(event -> event.text("payload")).toList();
    }

    private static String hex(String text) {
        return HexFormat.of().formatHex(text.getBytes(StandardCharsets.US_ASCII));
    }
}
