package systemtest;

import static harness.Host.get;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import harness.Emulator;
import harness.Host;
import harness.InEmulatedTime;
import java.nio.file.Path;
import java.util.Map;
import javino.board.SessionCounter;
import javino.protocol.Address;
import javino.protocol.Counter;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import trace.TraceEvent;

/** A Mega that begins with Arduino's own boot loader after each reset, as it does where it is not emulated. */
@Timeout(120)
@InEmulatedTime
class BootLoaderTest {

    /** The boot loader of Debian's arduino-core-avr, which the sketches are built with. */
    private static final String BOOT_LOADER =
            "/usr/share/arduino/hardware/arduino/avr/bootloaders/stk500v2/stk500boot_v2_mega2560.hex";
    /** The time from a reset to a board that serves: left alone, the boot loader takes 0.8, after a hello 5. */
    private static final double MOST_EMULATED_SECONDS = 4;
    /** A board holds a poll for ten times as long. */
    private static final double HELD_SECONDS = 0.2;

    private static Emulator.Scenario scenario(String sketch) {
        return new Emulator.Scenario().board("lamp", sketch, Map.of("bootLoader", BOOT_LOADER));
    }

    private static TraceEvent reset(Emulator emulator, String why) throws InterruptedException {
        return emulator.await(why, event -> event.is("reset", "lamp") && event.text("why").equals(why));
    }

    @Test
    void host_opensThePort_boardIsGreetedSoon(@TempDir Path folder) throws Exception {
        try (Emulator emulator = scenario("Station").start(folder); Host host = Host.of(emulator, "lamp")) {
            get(host.board.setRfId(Address.parse("ROMA")));
            TraceEvent done = emulator.await("its id", event -> event.is("host-id", "lamp"));
            double seconds = done.seconds() - reset(emulator, "port opened").seconds();
            assertTrue(seconds < MOST_EMULATED_SECONDS, seconds + " s");
            assertEquals(0, host.counter(Counter.SERIAL_DAMAGED));
        }
    }

    /** Waits until the board holds a poll: one that came just after a reset would keep the boot loader for long. */
    private static void awaitPoll(Host host) {
        long before;
        do {
            before = requests(host);
            Host.pause(HELD_SECONDS);
        } while (before == 0 || before != requests(host));
    }

    private static long requests(Host host) {
        return host.board.counters().get(SessionCounter.REQUESTS);
    }

    @Test
    @Tag("verify")
    void boardIsResetWhileItIsPolled_isGreetedAgain(@TempDir Path folder) throws Exception {
        try (Emulator emulator = scenario("Station").start(folder); Host host = Host.of(emulator, "lamp")) {
            int boots = get(host.board.greeted()).bootEpoch();
            awaitPoll(host);
            emulator.command(Map.of("do", "reset", "board", "lamp"));
            host.awaitOnline(2);
            assertTrue(host.board.info().orElseThrow().bootEpoch() > boots);
        }
    }

    @Test
    void boardWithTheOlderProtocol_isFound(@TempDir Path folder) throws Exception {
        try (Emulator emulator = scenario("OlderBoard").start(folder); Host host = Host.of(emulator, "lamp")) {
            assertTrue(get(host.board.greeted()).isLegacy());
            get(host.board.act("ledOn"));
            reset(emulator, "port opened");
        }
    }
}
