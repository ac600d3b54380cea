package javino.link;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.time.Duration;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class InMemoryLinkTest {

    private final InMemoryLink.Pair pair = InMemoryLink.pair("memory");
    private final byte[] buffer = new byte[3];

    @Test
    void read_moreThanTheBufferHolds_comesInParts() throws LinkException {
        pair.host().write(new byte[] {1, 2, 3, 4});
        assertEquals(3, pair.board().read(buffer, Duration.ofSeconds(30)));
        assertArrayEquals(new byte[] {1, 2, 3}, buffer);
        assertEquals(1, pair.board().read(buffer, Duration.ofSeconds(30)));
        assertEquals(4, buffer[0]);
    }

    @Test
    void read_nothingInTime_givesZero() throws LinkException {
        pair.host().write(new byte[0]);
        assertEquals(0, pair.board().read(buffer, Duration.ofMillis(1)));
    }

    @Test
    void wake_noBytes_endsOneReadThatWaitsOrTheComingOne() throws LinkException {
        pair.board().wake();
        pair.board().wake();
        assertEquals(0, pair.board().read(buffer, Duration.ofDays(1)));
        pair.host().write(new byte[] {7});
        assertEquals(1, pair.board().read(buffer, Duration.ofDays(1)));
        new Thread(pair.board()::wake).start();
        assertEquals(0, pair.board().read(buffer, Duration.ofDays(1)));
    }

    @Test
    void close_afterWriting_leavesWhatWasWritten() throws LinkException {
        pair.host().write(new byte[] {7});
        pair.host().close();
        assertEquals(1, pair.board().read(buffer, Duration.ofSeconds(30)));
        for (InMemoryLink end : Arrays.asList(pair.board(), pair.host())) {
            LinkException e = assertThrows(LinkException.class, () -> end.read(buffer, Duration.ofSeconds(30)));
            assertEquals("memory: the link is closed", e.getMessage());
            assertThrows(LinkException.class, () -> end.write(new byte[1]));
        }
    }
}
