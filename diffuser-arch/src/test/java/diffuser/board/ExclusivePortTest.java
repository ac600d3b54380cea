package diffuser.board;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.Semaphore;

import javino.fake.FakeBoard;
import javino.link.Link;
import javino.link.LinkException;
import javino.link.LinkOpener;
import javino.link.Time;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class ExclusivePortTest {

    private static final String PORT = "port of several";

    private final FakeBoard board = new FakeBoard(PORT);
    private final ExclusivePort first = turn("first");
    private final ExclusivePort second = turn("second");
    /** How often the third has looked whether it can have the port. */
    private final Semaphore looks = new Semaphore(0);
    private final ExclusivePort third = new ExclusivePort(new LinkOpener() {
        @Override
        public Link open() throws LinkException {
            return board.port.open();
        }

        @Override
        public String name() {
            looks.release();
            return PORT;
        }
    }, "third", CompletableFuture.completedFuture(null), Time.REAL);

    private ExclusivePort turn(String agent) {
        return new ExclusivePort(board.port, agent, CompletableFuture.completedFuture(null), Time.REAL);
    }

    @AfterEach
    void leave() {
        Set.of(first, second, third).forEach(ExclusivePort::leave);
    }

    /** Opens the port on a thread of its own. */
    private static CompletableFuture<Link> opening(ExclusivePort turn) {
        return CompletableFuture.supplyAsync(() -> {
            try {
                return turn.open();
            } catch (LinkException e) {
                throw new CompletionException(e);
            }
        }, task -> new Thread(task).start());
    }

    @Test
    void open_anotherComesFirst_waitsForThatToo() throws Exception {
        first.open().close();
        CompletableFuture<Link> opened = opening(third);
        looks.acquire();
        while (first.left.getNumberOfDependents() == 0) {
            Thread.onSpinWait();
        }
        // As if the second had come first to the port that the first leaves.
        ExclusivePort.HOLDERS.remove(new ExclusivePort.Port(Time.REAL, PORT), first);
        second.open().close();
        first.leave();
        looks.acquire();
        second.leave();
        opened.join().close();
    }

    @Test
    void open_whoHasItStays_saysWho() throws Exception {
        first.open().close();
        LinkException refused = (LinkException) assertThrows(CompletionException.class,
                () -> opening(second).join()).getCause();
        assertEquals(PORT + ": agent first of this MAS has it; give each board a port of its own, or have it left"
                + " there first", refused.getMessage());
    }
}
