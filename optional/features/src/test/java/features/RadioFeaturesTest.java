package features;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Features of a robot with a radio, of devices that are played, and of an attacker. */
class RadioFeaturesTest {

    private static final String AGENT = """
            !start.
            +!start <- .port("ports/robot"); .setMyRFId("ROMA"); .getRFMessages(open); .percepts(open).
            +hello(X)[source(S)] <- .print("hello ", X, " from ", S).
            +!ask <- .diffuse("SUPO", tell, question(1)).
            """;
    private static final String DEVICE = "Given the device SUPO / ";
    private static final String SEALED = DEVICE + "And ROMA (robot's board) and the device SUPO share a key / ";
    private static final String WRONG_KEY =
            DEVICE + "And ROMA (robot's board) and the device SUPO have different keys / ";
    private static final String SENDS = "When the device SUPO sends tell hello(1) to ROMA / ";

    @AutoClose
    private final Project project;

    RadioFeaturesTest(@TempDir Path folder) throws IOException {
        project = new Project(folder, "radioblink/RadioBlink", AGENT);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', value = {
            DEVICE + "When the device SUPO sends tell hello(1) by broadcast / "
                    + "Then the agent robot believes hello(1) from SUPO "
                    + "/ And it prints \"hello 1 from SUPO\"",
            SEALED + SENDS + "Then within 5 s the message of the device SUPO is delivered / "
                    + "And within 5 s the agent robot believes hello(1) from SUPO, sealed / "
                    + "When the agent robot gets the goal ask / "
                    + "Then within 5 s the device SUPO gets tell question(1) exactly "
                    + "1 time / When an attacker repeats the last packet of SUPO / "
                    + "Then not within 2 s it believes hello(1)",
            WRONG_KEY + SENDS + "Then within 3 s the counter radioBadTag of the agent robot rises / "
                    + "And not within 4 s it believes hello(1)",
            DEVICE + "When the radio is jammed for 2 s / And the device SUPO sends tell hello(1) by broadcast / "
                    + "Then not within 1 s the agent robot believes hello(_)",
            DEVICE + "And the radio's bit error rate is 0.3 / When the device SUPO sends tell hello(1) by broadcast / "
                    + "Then not within 2 s the agent robot believes hello(_)",
            "When an attacker sends tell hello(2) as SUPO / Then the agent robot believes hello(2) from SUPO",
    })
    void steps_whatIsSo_pass(String steps) throws IOException {
        assertEquals(0, project.play(steps), project.said());
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', value = {
            WRONG_KEY + SENDS + "Then within 5 s the agent robot believes hello(1)|radioBadTag ",
            WRONG_KEY + SENDS
                    + "Then within 5 s the message of the device SUPO is delivered|no message of the device SUPO is",
            SEALED + SENDS + "Then within 5 s the agent robot believes hello(1) from ROMA|believe hello(1) from ROMA",
            "When an attacker sends tell hello(2) as SUPO / "
                    + "Then the agent robot believes hello(2), sealed|hello(2), sealed",
            SEALED + SENDS
                    + "Then not within 3 s the counter radioReceived of the agent robot rises|radioReceived rises",
            "When the device SUPO sends tell a to ROMA|there is no device SUPO",
            DEVICE + "When the device SUPO sends wish a to ROMA|expected a performative such as tell",
            "Given the radio loses a share of 2 / When 1 s passes|radio.loss",
            "When an attacker repeats the last packet of robot|robot has sent no packet",
            "Given ROMA (robot's board) and the device SUPO share a key|there is no device SUPO yet",
    })
    void steps_whatIsNotSo_failAndSayWhatWasSeen(String steps, String expected) throws IOException {
        assertEquals(1, project.play(steps), project.said());
        assertTrue(project.said().contains(expected), project.said());
    }
}
