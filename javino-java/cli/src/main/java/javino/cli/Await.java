package javino.cli;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import javino.JavinoException;
import javino.board.Board;

/** Waits for a board, by the board's time. */
public final class Await {

    private Await() {
    }

    /**
     * The result of a request.
     *
     * @throws JavinoException why there is none.
     */
    public static <T> T result(Board board, CompletableFuture<T> request) throws JavinoException, InterruptedException {
        try {
            return board.time().get(request);
        } catch (ExecutionException e) {
            if (e.getCause() instanceof JavinoException cause) {
                throw cause;
            }
            throw new IllegalStateException(e.getCause());
        }
    }

    /** Waits for so long. */
    static void pause(Board board, long millis) throws InterruptedException {
        board.time().pause(TimeUnit.MILLISECONDS.toNanos(millis));
        if (Thread.interrupted()) {
            throw new InterruptedException();
        }
    }
}
