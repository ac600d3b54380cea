package javino.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import javino.protocol.Capability;
import javino.protocol.Counter;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import picocli.CommandLine.Help.Ansi;

@Tag("newerJava")
class MonitorCommandTest extends CommandFixture {

    private void startOnline() throws InterruptedException {
        start("monitor", "--port", "fake");
        await("online");
    }

    /** The lines that were told, without the times. */
    private List<String> told() {
        return lines().stream().map(line -> line.replaceFirst("^ *\\d+\\.\\d{3} s  ", "")).toList();
    }

    @Test
    void online_board_isNamedWithTheTime() throws Exception {
        fake.setRfId("ROMA");
        startOnline();
        assertEquals(0, interrupt());
        assertTrue(lines().get(0).matches(" *\\d+\\.\\d{3} s  online    fake, RF id ROMA, boot epoch 1"),
                out.toString());
        assertEquals("", err.toString());
    }

    @Test
    void online_boardWithoutRadio_isWatchedWithoutIt() throws Exception {
        fake.setCapabilities(Capability.SAYS_TAKEN).perceive("dark");
        startOnline();
        awaitLine("percept   +dark");
        assertEquals(0, interrupt());
        assertTrue(told().contains("online    fake, no radio"), out.toString());
        assertEquals(List.of(), List.copyOf(fake.requests));
    }

    @Test
    void printed_lines_areShownAndWarnedOf() throws Exception {
        fake.line.setPrints("t = 20.99\r\nh = 3\r\n");
        startOnline();
        awaitLine("printed   t = 20.99");
        awaitLine("printed   h = 3");
        await("warning   the sketch prints on the line of the protocol");
    }

    @Test
    void count_timeThatIsLong_isNoLoss() throws Exception {
        fake.setCounter(Counter.LOOP_MILLIS, 30).setCounter(Counter.ACTION_MILLIS, 5);
        startOnline();
        awaitLine("longest   loopMillis 30");
        assertFalse(out.toString().contains("actionMillis"));
    }

    @ParameterizedTest
    @CsvSource({"SUPO,sealed", "//SU,sealed", "////,plain"})
    void message_each_isToldWithHowItCame(String to, String how) throws Exception {
        fake.receive(to, "ROMA", 0, "tell;help");
        startOnline();
        await("tell;help");
        assertEquals(0, interrupt());
        assertTrue(told().contains(String.format("message   ROMA -> %s  %-6s  tell;help", to, how)), out.toString());
    }

    @Test
    void message_commandsForTheTerminal_areWritten() throws Exception {
        fake.receive("////", "ROMA", 0, "tell;x\033]0;title\007\n0.000 s  online");
        startOnline();
        awaitLine("tell;x\\u001b]0;title\\u0007\\u000a0.000 s  online");
    }

    @Test
    void message_noContent_isAWarning() throws Exception {
        fake.receive("////", "ROMA", 0, "nonsense");
        startOnline();
        await("warning   a message from ROMA was skipped");
    }

    @Test
    void percepts_changes_areTold() throws Exception {
        fake.perceive("light(311)");
        startOnline();
        awaitLine("percept   +light(311)");
        fake.perceive("light(312)");
        awaitLine("percept   +light(312)");
        assertEquals(0, interrupt());
        assertTrue(told().contains("percept   -light(311)"), out.toString());
    }

    @Test
    void counters_ofRadioAndLosses_areToldWhenTheyRise() throws Exception {
        fake.setCounter(Counter.RADIO_NO_KEY, 2);
        startOnline();
        awaitLine("dropped   radioNoKey 2 (+2)");
        fake.setCounter(Counter.RADIO_NO_KEY, 3);
        fake.setCounter(Counter.RADIO_RECEIVED, 4);
        fake.setCounter(Counter.RADIO_UNDELIVERED, 1);
        awaitLine("dropped   radioNoKey 3 (+1)");
        awaitLine("counted   radioReceived 4 (+4)");
        awaitLine("counted   radioUndelivered 1 (+1)");
        assertFalse(out.toString().contains("serialRequests"), out.toString());
    }

    @Test
    void radio_isOpenWhileItRuns() throws Exception {
        startOnline();
        await(out, written -> fake.line.count('S') > 1);
        assertEquals(0, interrupt());
        List<String> radio = fake.requests.stream().filter(what -> what.startsWith("radio")).toList();
        assertEquals(List.of("radio 1", "radio 0"), radio);
    }

    @Test
    void board_unpluggedAndBack_isToldAndTheRadioOpenedAnew() throws Exception {
        startOnline();
        await(out, written -> fake.line.count('S') > 1);
        port.unplug();
        awaitLine("offline   fake: there is no such port");
        fake.reset();
        port.plug();
        await("boot epoch 2");
        assertEquals(0, interrupt());
        List<String> radio = fake.requests.stream().filter(what -> what.startsWith("radio")).toList();
        assertEquals(List.of("radio 1", "radio 1", "radio 0"), radio);
    }

    @Test
    void board_ofAnotherVersionComes_ends() throws Exception {
        startOnline();
        await(out, written -> fake.line.count('S') > 1);
        fake.setVersion(2);
        fake.reset();
        assertEquals(1, status());
        assertEquals(1, err.toString().lines().count(), err.toString());
        assertTrue(err.toString().contains("the board speaks version 2"), err.toString());
    }

    @Test
    void colours_areForTerminalsOnly() throws Exception {
        startOnline();
        interrupt();
        assertFalse(out.toString().contains("\033["), out.toString());
        ansi = Ansi.ON;
        startOnline();
        await("\033[32monline");
    }
}
