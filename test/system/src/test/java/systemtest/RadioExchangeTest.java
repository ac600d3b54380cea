package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import harness.Emulator;
import harness.Host;
import harness.InEmulatedTime;
import harness.TestKeys;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import javino.protocol.Counter;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import trace.TraceEvent;

/** Two boards of a group, and a third of another group that hears all they send. */
@InEmulatedTime
class RadioExchangeTest {

    @AutoClose
    private Emulator emulator;
    private Host police;
    private Host support;
    private Host bus;

    @BeforeEach
    void switchOn(@TempDir Path folder) throws Exception {
        emulator = new Emulator.Scenario()
                .board("police", "Vehicle").board("support", "Station").board("bus", "Vehicle")
                .start(folder);
        police = Host.of(emulator, "police").as("SUPO", Map.of("SUPP", TestKeys.PAIR, "//SU", TestKeys.GROUP));
        support = Host.of(emulator, "support").as("SUPP", Map.of("SUPO", TestKeys.PAIR, "//SU", TestKeys.GROUP));
        bus = Host.of(emulator, "bus").as("ROMA", Map.of());
    }

    @Test
    void broadcast_reachesAllInPlain() throws Exception {
        police.send("////", "tell;roadClosed");

        assertEquals("SUPO to ////: tell;roadClosed", support.received());
        assertEquals("SUPO to ////: tell;roadClosed", bus.received());
        emulator.await("the broadcast", event -> event.name().equals("rf-tx") && tells(event, "tell;roadClosed"));
    }

    @Test
    void multicast_reachesItsGroupAloneAndSealed() throws Exception {
        police.send("//SU", "tell;someoneNeedHelp");

        assertEquals("SUPO to //SU: tell;someoneNeedHelp", support.received());
        assertNotHeardByBus("someoneNeedHelp");
    }

    @Test
    @Tag("verify")
    void unicast_reachesItsDeviceAloneAndSealed() throws Exception {
        police.send("SUPP", "achieve;comeTo(\"km 12\")");

        assertEquals("SUPO to SUPP: achieve;comeTo(\"km 12\")", support.received());
        assertNotHeardByBus("comeTo");
    }

    @Test
    void sameContentTwice_looksDifferentOnAir() throws Exception {
        police.send("SUPP", "tell;help");
        police.send("SUPP", "tell;help");

        List<String> sealed = emulator.sentBy("police").stream().map(packet -> packet.text("payload"))
                .map(payload -> payload.substring(20 + 12)).toList();
        assertEquals(2, sealed.size());
        assertNotEquals(sealed.get(0), sealed.get(1));
    }

    private void assertNotHeardByBus(String plaintext) {
        assertTrue(bus.counter(Counter.RADIO_NOT_FOR_US) > 0);
        assertEquals(List.of(), bus.messages());
        assertFalse(onAir(plaintext), "the plaintext was on the air");
    }

    /** Whether a text stands anywhere in what the radio's sniffer, or a board without a host, made known. */
    private boolean onAir(String text) {
        return emulator.trace().stream().filter(event -> !event.name().startsWith("host-"))
                .anyMatch(event -> tells(event, text));
    }

    private static boolean tells(TraceEvent event, String text) {
        return event.line().contains(text)
                || event.line().contains(HexFormat.of().formatHex(text.getBytes(StandardCharsets.UTF_8)));
    }
}
