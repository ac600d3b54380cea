package systemtest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import harness.Emulator;
import harness.Host;
import harness.InEmulatedTime;
import harness.TestKeys;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ExecutionException;
import javino.board.AirtimeHour;
import javino.board.AirtimeUsedException;
import javino.board.Transmission;
import javino.protocol.Address;
import javino.protocol.Content;
import javino.protocol.Outcome;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The hosts of a board that may send for 1 % of each hour, and of one without a limit. */
@InEmulatedTime
class AirtimeHostTest {

    @AutoClose
    private Emulator emulator;
    private Host limited;
    private Host free;

    @BeforeEach
    void switchOn(@TempDir Path folder) throws Exception {
        emulator = new Emulator.Scenario().board("limited", "LimitedStation").board("free", "Station").start(folder);
        limited = Host.of(emulator, "limited").as("SUPO", Map.of("ROMA", TestKeys.PAIR));
        free = Host.of(emulator, "free").as("ROMA", Map.of("SUPO", TestKeys.PAIR));
    }

    private Transmission transmit(int number) {
        return limited.board.transmit(Address.parse("ROMA"), Content.parse("tell;n(" + number + ")"));
    }

    private AirtimeHour.Use airtime(Host host) {
        return host.board.airtime().orElseThrow();
    }

    /** Messages that the board has taken, until it takes no more. */
    private List<Transmission> fill() throws ExecutionException {
        List<Transmission> taken = new ArrayList<>();
        while (taken.size() < 100) {
            Transmission next = transmit(taken.size());
            try {
                Host.await(next.taken());
                taken.add(next);
            } catch (ExecutionException e) {
                AirtimeUsedException used = assertInstanceOf(AirtimeUsedException.class, e.getCause());
                assertEquals(airtime(limited).waitSeconds(), used.seconds(), 1);
                return taken;
            }
        }
        throw new AssertionError("the board takes all");
    }

    @Test
    @Tag("verify")
    void messages_beyondTheLimit_areRefusedWithTheTimeAlsoAfterAReset() throws Exception {
        assertTrue(fill().size() > 1);
        long seconds = airtime(limited).waitSeconds();
        assertTrue(seconds > 60 && seconds < 130, "the limit begins spent: " + seconds);
        limited.close();
        limited = Host.of(emulator, "limited").as("SUPO", Map.of("ROMA", TestKeys.PAIR));
        assertTrue(fill().size() > 1);
        assertTrue(airtime(limited).waitSeconds() > seconds - 40, "the port's opening has reset the board");
    }

    @Test
    void messages_thatWaitForTheLimit_goOnAtTheTimeThatWasTold() throws Exception {
        Transmission first = fill().get(0);
        long seconds = airtime(limited).waitSeconds();
        assertFalse(first.end().isDone());
        Host.pause(seconds);
        assertEquals(Outcome.DELIVERED, Host.await(first.end()));
    }

    @Test
    void airtime_ofAnIdleBoard_isReadOnceAMinute() throws Exception {
        assertEquals(new AirtimeHour.Use(0, 0, 0), airtime(free));
        for (int i = 0; i < 3; i++) {
            assertEquals(Outcome.SENT, free.send("////", "tell;" + "x".repeat(400)));
        }
        Host.pause(62);
        double share = airtime(free).share();
        assertTrue(share > 0.1 && share < 1, "" + share);
        assertEquals(share, airtime(free).most());
    }
}
