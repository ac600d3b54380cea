package diffuser;

import java.util.HashMap;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.function.Supplier;

import javino.protocol.Outcome;

/** What is under way by radio from one board, whose session tells outcomes by their numbers (SPEC 4.3). */
final class Transmissions {

    private final Map<Integer, CompletableFuture<Outcome>> underWay = new HashMap<>();

    /**
     * A transmission that was asked for.
     *
     * @param taken   completes when the board has taken the message, and fails if it has not.
     * @param outcome completes, after that, when the message has ended; never, if it was not taken.
     */
    record Transmission(CompletableFuture<Integer> taken, CompletableFuture<Outcome> outcome) {
    }

    /**
     * Follows a transmission.
     *
     * @param ask asks for it, and returns its number to come. Called with the lock held, for which {@link #ended} waits:
     *            so no outcome is told before its number is known here, however quick the board.
     */
    synchronized Transmission begin(Supplier<CompletableFuture<Integer>> ask) {
        CompletableFuture<Outcome> outcome = new CompletableFuture<>();
        CompletableFuture<Integer> taken = ask.get();
        taken.thenAccept(number -> put(number, outcome));
        return new Transmission(taken, outcome);
    }

    private void put(int number, CompletableFuture<Outcome> outcome) {
        CompletableFuture<Outcome> former = replace(number, outcome);
        // Numbers come again after 256; what has no outcome by then gets none.
        if (former != null) {
            former.complete(Outcome.UNDELIVERED);
        }
    }

    private synchronized CompletableFuture<Outcome> replace(int number, CompletableFuture<Outcome> outcome) {
        return underWay.put(number, outcome);
    }

    /** A transmission has ended; one that was not begun here, as by another program before, is nobody's business. */
    void ended(int number, Outcome outcome) {
        CompletableFuture<Outcome> waiting = remove(number);
        if (waiting != null) {
            waiting.complete(outcome);
        }
    }

    private synchronized CompletableFuture<Outcome> remove(int number) {
        return underWay.remove(number);
    }
}
