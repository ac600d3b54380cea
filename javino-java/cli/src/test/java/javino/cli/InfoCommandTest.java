package javino.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import javino.protocol.Bytes;
import javino.protocol.Capability;
import javino.protocol.Counter;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

class InfoCommandTest extends CommandFixture {

    private List<String> radio() {
        return fake.requests.stream().filter(what -> what.startsWith("radio")).toList();
    }

    @Test
    void board_isShown() {
        fake.setActions("lampOn", "lampOff");
        fake.keys.setSession("ROMA", Bytes.of(4, 5, 6));
        assertEquals(0, run("info", "--port", "fake"), err.toString());
        assertEquals(List.of("firmware              fake", "protocol version      1", "library               current",
                "radio                 yes", "RF id                 none", "boot epoch            1",
                "actions               lampOn, lampOff",
                "key                   SUPO, check value 010203", "session key           ROMA, check value 040506",
                "serialRequests        9", "airtime               0.0 % of the last hour, at most 0.0 % of one"),
                lines());
        assertEquals(List.of(), radio());
    }

    @Test
    void board_withoutRadio_isShown() {
        fake.setCapabilities(Capability.SAYS_TAKEN).setFirmware("blink 1.0");
        assertEquals(0, run("info", "--port", "fake", "--after", "1"), err.toString());
        assertEquals(
                List.of("firmware              blink 1.0", "protocol version      1", "library               current",
                        "radio                 none: the board has percepts and actions", "actions               none",
                        "serialRequests        +0"),
                lines());
        assertEquals(List.of(), List.copyOf(fake.requests));
    }

    @Test
    void board_ofAnEarlierLibrary_saysSo() {
        fake.setCapabilities(Capability.RADIO, Capability.MEMORY);
        run("info", "--port", "fake");
        assertTrue(lines().contains("library               earlier; flash the sketch anew"), out.toString());
    }

    @Test
    void after_times_areShownAsTheyAre() {
        fake.setCounter(Counter.LOOP_MILLIS, 30);
        assertEquals(0, run("info", "--port", "fake", "--after", "1"), err.toString());
        assertTrue(lines().contains("loopMillis            30"), out.toString());
    }

    @ParameterizedTest
    @EnumSource
    void counter_isApartFromItsName(Counter counter) {
        assertEquals(List.of(counter.toString(), "7"), List.of(InfoCommand.line(counter, 7).split(" +")));
    }

    @Test
    void after_someTime_showsByHowMuchCountersRoseWithTheRadioOpen() {
        fake.setCounter(Counter.RADIO_RECEIVED, 5);
        fake.setRise(Counter.RADIO_RECEIVED, 3);
        assertEquals(0, run("info", "--port", "fake", "--after", "1"), err.toString());
        assertTrue(lines().contains("RF id                 none"), out.toString());
        assertTrue(lines().containsAll(List.of("serialRequests        +0", "radioReceived         +3")),
                out.toString());
        assertEquals(List.of("radio 1", "radio 0"), radio());
    }

    @Test
    void after_boardBooted_saysThatItCountsAnew() {
        AtomicBoolean isReset = new AtomicBoolean();
        fake.line.setFault(reply -> {
            if (fake.line.count('S') > 1 && isReset.compareAndSet(false, true)) {
                fake.reset();
            }
            return reply;
        });
        assertEquals(1, run("info", "--port", "fake", "--after", "1"));
        assertEquals("javino: fake: the board has booted meanwhile, and counts from 0; try again",
                err.toString().strip());
    }

    @Test
    void after_interrupted_blocksTheRadio() throws InterruptedException {
        start("info", "--port", "fake", "--after", "3600");
        await(out, written -> fake.line.count('S') > 1);
        assertEquals(0, interrupt());
        assertEquals(List.of("radio 1", "radio 0"), radio());
    }

    @ParameterizedTest
    @ValueSource(strings = {"0", "3601", "-1", "soon"})
    void after_noSuchTime_isWrongUsage(String seconds) {
        assertFails(2, "--after", "info", "--port", "fake", "--after", seconds);
    }
}
