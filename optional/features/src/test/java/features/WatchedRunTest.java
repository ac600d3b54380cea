package features;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class WatchedRunTest {

    private static String sent(int seconds, String fields) {
        return "{\"t\": " + seconds + ", \"board\": \"robot\", \"event\": \"rf-tx\", " + fields + "}";
    }

    /** The run has begun before, and goes on while scenarios wait. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', value = {
            "Then within 1 min the agent robot prints \"a\" / And within 1 min robot's lamp is on|",
            "Then within 1 min the agent robot prints a line with \"wor\" / And within 1 s robot's lamp is on|",
            "Then within 1 min robot's board broadcasts tell help|",
            "Then within 1 min robot's board sends a sealed message to SUPO|",
            "Then within 1 min robot's board sends a sealed message to //SU|"
                    + "robot's board sends no packet to //SU, sealed",
            "Then robot's lamp is on|",
            "Then robot's lamp is off|robot's lamp is on",
            "Then within 1 min robot's lamp is off|robot's lamp does not go off",
            "Then within 2 s the agent robot prints a line with \"wor\"|robot does not print a line with \"wor\"",
            "Then never the agent robot prints \"b\"|",
            "Then never the agent robot prints \"a\"|it happens at 1.000 s",
            "When robot's board is reset|this run is only watched: its steps see, and do nothing",
            "When the agent robot gets the goal go|this run is only watched: its steps see, and do nothing",
            "Given the device SUPO|this run is only watched: its steps see, and do nothing",
            "Then within 1 s the counter radioSent of the agent robot rises|"
                    + "this run is only watched: its steps see, and do nothing",
            "Then I like it|no step has these words",
    })
    void scenario_ofARunThatGoesOn_seesItFromItsBeginning(String steps, String missing, @TempDir Path folder)
            throws IOException {
        Path boards = Files.writeString(folder.resolve("board.json"),
                "{\"boards\": [{\"name\": \"robot\", \"firmware\": \"none\", "
                        + "\"watch\": [{\"pin\": 13, \"name\": \"lamp\"}]}]}");
        Path feature = Files.writeString(folder.resolve("a.feature"),
                "Feature: a\n\n  Scenario: b\n" + steps.replace(" / ", "\n"));
        List<String> coming = new ArrayList<>(List.of(
                sent(2, "\"destination\": \"////\", \"content\": \"tell;help\""),
                sent(3, "\"destination\": \"SUPO\", \"sealed\": true")));
        WatchedRun run = new WatchedRun(boards);
        run.traced("{\"t\": 1, \"board\": \"robot\", \"event\": \"pin\", \"name\": \"lamp\", \"level\": 1}");
        run.printed("robot", "a");
        List<WatchedRun.Ended> ended = new ArrayList<>();
        run.play(List.of(feature), wanted -> {
            while (!wanted.getAsBoolean() && !coming.isEmpty()) {
                run.traced(coming.remove(0));
                if (coming.isEmpty()) {
                    run.printed("robot", "words");
                }
            }
            return wanted.getAsBoolean();
        }, ended::add);

        assertEquals(List.of("b"), WatchedRun.scenarios(List.of(feature)));
        assertEquals(List.of(new WatchedRun.Ended("b", missing == null ? "" : missing)), ended);
    }
}
