package capture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import javino.protocol.BoardInfo;
import javino.protocol.Bytes;
import javino.protocol.PollReply.Reception;
import javino.protocol.PollReply.Overheard;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

class OverheardPacketsTest {

    private static final long SECOND = 1_000_000;
    private static final BoardInfo INFO = new BoardInfo(1, Optional.empty(), 1, Set.of(), "test", List.of());

    private final List<AirPacket> taken = new ArrayList<>();
    private final BlockingQueue<String> notes = new LinkedBlockingQueue<>();
    private long now = 1000 * SECOND;
    private final OverheardPackets ear = new OverheardPackets("ttyACM0", notes::add, () -> now);

    /** When a packet was, that the board has told now. */
    private long hear(long millis) {
        ear.to(taken::add);
        ear.overheard(new Overheard(millis, Reception.INTACT, Bytes.ofText("x")));
        return taken.get(taken.size() - 1).micros() - 1000 * SECOND;
    }

    @Test
    void time_isTheBoardsFromPacketToPacket() {
        assertEquals(0, hear(5000));
        // Told late.
        now += SECOND + 40_000;
        assertEquals(SECOND, hear(6000));
        now += SECOND;
        assertEquals(2 * SECOND, hear(7000));
    }

    @Test
    void time_thatThisComputerSees_boundsTheBoards() {
        hear(5000);
        // The board's clock is fast, then slow, then starts anew.
        now += SECOND;
        assertEquals(SECOND, hear(6500));
        now += SECOND;
        assertEquals(2 * SECOND - 100_000, hear(6600));
        now += SECOND;
        ear.online(INFO);
        assertEquals(3 * SECOND, hear(10));
        now += SECOND;
        assertEquals(4 * SECOND, hear(1010));
    }

    @Test
    void packets_keepHowTheyCame() {
        ear.to(taken::add);
        for (Reception how : Reception.values()) {
            ear.overheard(new Overheard(1, how, Bytes.EMPTY));
        }
        assertEquals(List.of(AirPacket.How.INTACT, AirPacket.How.MENDED, AirPacket.How.DAMAGED),
                taken.stream().map(AirPacket::how).toList());
    }

    @Test
    void reader_thatHasGone_endsIt() throws Exception {
        ear.to(packet -> {
            throw new IOException("Broken pipe");
        });
        assertFalse(ear.awaitBroken(0));
        ear.overheard(new Overheard(1, Reception.INTACT, Bytes.EMPTY));
        assertTrue(ear.awaitBroken(0));
    }

    @Test
    @Timeout(60)
    void board_thatGoesAndComes_isTold() throws Exception {
        ear.offline("never there");
        ear.online(INFO);
        ear.online(INFO);
        ear.offline("unplugged");
        assertEquals("the board is there again", notes.take());
        assertEquals("unplugged", notes.take());
    }

    @Test
    void board_thatGoesWithTheCapture_isNoNews() throws Exception {
        ear.online(INFO);
        ear.offline("the port was closed");
        ear.end();
        assertNull(notes.poll(1, TimeUnit.SECONDS));
    }
}
