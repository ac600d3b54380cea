package javino.cli;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import javino.JavinoException;

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
        try {
            return future.get();
        } catch (ExecutionException e) {
            if (e.getCause() instanceof JavinoException cause) {
                throw cause;
            }
            throw new IllegalStateException(e.getCause());
        }
    }
}
