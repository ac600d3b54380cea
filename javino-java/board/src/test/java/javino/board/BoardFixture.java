package javino.board;

import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.time.Duration;
import java.time.Instant;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutionException;
import java.util.function.Consumer;
import javino.fake.FakeBoard;
import javino.fake.FakePort;
import javino.keyring.BoundedClock;
import javino.protocol.Address;
import javino.protocol.Content;
import javino.protocol.Performative;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Timeout;

/** A session with a fake board, at times that suit tests; closed after each. */
@Timeout(60)
abstract class BoardFixture {

    static final Address SUPO = Address.parse("SUPO");
    static final Content HELP = new Content(Performative.TELL, "help");

    final FakeBoard fake = new FakeBoard();
    final FakePort port = fake.port;
    final RecordingListener listener = new RecordingListener();
    Board board;

    /** No host has raised the board's epoch, nor does the session, by the clock of a computer that has none. */
    BoardFixture() {
        fake.keys.setEpoch(1);
    }

    /** Opens a session that tells {@code told}. */
    final void open(BoardListener told) {
        open(told, config -> {});
    }

    /** Opens a session that tells {@code told}, with some settings of its own. */
    final void open(BoardListener told, Consumer<BoardConfig.Builder> settings) {
        board = Board.open(port, quick(settings), told);
    }

    @AfterEach
    final void close() {
        if (board != null) {
            board.close();
        }
    }

    /** Settings with which little is waited for. */
    static BoardConfig quick(Consumer<BoardConfig.Builder> settings) {
        return BoardConfig.create(builder -> settings.accept(builder.setHold(Duration.ofMillis(20))
                .setReplyTimeout(Duration.ofMillis(20)).setActionTime(Duration.ofSeconds(1))
                .setHelloInterval(Duration.ofMillis(10))
                .setReopenInterval(Duration.ofMillis(10)).setPatience(Duration.ofSeconds(30)).setAttempts(20)
                .setClock(BoundedClock.at(Instant.EPOCH))));
    }

    static <T extends Throwable> T failure(Class<T> type, CompletableFuture<?> future) {
        return assertInstanceOf(type, assertThrows(ExecutionException.class, future::get).getCause());
    }

    static void await(CountDownLatch latch) {
        try {
            latch.await();
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }
}
