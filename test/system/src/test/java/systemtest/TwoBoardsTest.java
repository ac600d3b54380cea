package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;

import harness.Emulator;
import harness.Host;
import harness.InEmulatedTime;
import harness.SerialMonitor;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The example TwoBoards, by what is typed and with agents. */
@InEmulatedTime
class TwoBoardsTest {

    @Test
    void twoBoards_chatByWhatIsTyped(@TempDir Path folder) throws Exception {
        try (Emulator emulator = new Emulator.Scenario()
                .board("one", "TwoBoards", Map.of("model", "uno"))
                .board("other", "TwoBoards",
                        Map.of("sensors",
                                List.of(Map.of("type", "digital", "pin", 2, "level", List.of(List.of(0, 0))))))
                .start(folder);
                SerialMonitor one = SerialMonitor.of(emulator, "one");
                SerialMonitor other = SerialMonitor.of(emulator, "other")) {
            assertEquals("ALFA: type a line", one.line());
            assertEquals("BETA: type a line", other.line());

            one.type("hello there\n");
            assertEquals("ALFA: hello there", other.line());
            other.type("hello to you\r\n");
            assertEquals("BETA: hello to you", one.line());

            one.type("x".repeat(68) + "\n");
            assertEquals("too long, not sent: 67 bytes at most", one.line());
            one.type("x".repeat(67) + "\n");
            assertEquals("ALFA: " + "x".repeat(67), other.line());
        }
    }

    @Test
    @Tag("verify")
    void twoBoards_isUnderstoodByAgentsAndUnderstandsThem(@TempDir Path folder) throws Exception {
        try (Emulator emulator =
                new Emulator.Scenario().board("one", "TwoBoards").board("station", "Station").start(folder);
                SerialMonitor one = SerialMonitor.of(emulator, "one");
                Host station = Host.of(emulator, "station").as("ROMA", Map.of())) {
            assertEquals("ALFA: type a line", one.line());
            one.type("tell;hello\n");
            assertEquals("tell;hello", station.content());
            station.send("////", "tell;welcome");
            assertEquals("ROMA: tell;welcome", one.line());
        }
    }
}
