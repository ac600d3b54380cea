package javino.board;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentLinkedQueue;

/** Who waits for percepts that the board is yet to be asked for. Wanted by any thread; the rest is for the session's. */
final class Readings {

    private final Queue<Reading> wanted = new ConcurrentLinkedQueue<>();
    private final List<Reading> underWay = new ArrayList<>();

    private record Reading(Duration within, CompletableFuture<Void> taken) {
    }

    /** Completes when percepts that were asked for after this were told, or where none will be; never fails. */
    CompletableFuture<Void> want(Duration within) {
        Reading reading = new Reading(within, new CompletableFuture<>());
        wanted.add(reading);
        return reading.taken();
    }

    /** Percepts are due no sooner: who does not wait that long need not wait at all. */
    void notBefore(Duration due) {
        wanted.removeIf(reading -> {
            boolean inVain = reading.within().compareTo(due) < 0;
            if (inVain) {
                reading.taken().complete(null);
            }
            return inVain;
        });
    }

    /** Percepts are asked for now. */
    void asked() {
        for (Reading reading = wanted.poll(); reading != null; reading = wanted.poll()) {
            underWay.add(reading);
        }
    }

    /** What was asked for was told. */
    void taken() {
        underWay.forEach(reading -> reading.taken().complete(null));
        underWay.clear();
    }

    /** There will be none. */
    void none() {
        asked();
        taken();
    }
}
