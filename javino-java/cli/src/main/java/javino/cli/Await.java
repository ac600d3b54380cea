package javino.cli;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import javino.JavinoException;
import javino.link.Time;

/** Waits for a board. */
public final class Await {

    private Await() {
    }

    /**
     * The result of a request.
     *
     * @throws JavinoException why there is none.
     */
    public static <T> T result(CompletableFuture<T> future) throws JavinoException, InterruptedException {
        return result(future, Time.REAL);
    }

    /** The same, in another time. */
    static <T> T result(CompletableFuture<T> future, Time time) throws JavinoException, InterruptedException {
        try {
            return time.get(future);
        } catch (ExecutionException e) {
            if (e.getCause() instanceof JavinoException cause) {
                throw cause;
            }
            throw new IllegalStateException(e.getCause());
        }
    }
}
