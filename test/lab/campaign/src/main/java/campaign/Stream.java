package campaign;

import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BooleanSupplier;
import javino.link.Time;
import javino.protocol.Address;
import lockstep.Simulation;

/** Unicasts one after the other from one endpoint to another: as one ends the next begins, so that some always wait. */
final class Stream {

    private final Endpoint from;
    private final Address to;
    private final Ledger ledger;
    private final BooleanSupplier goOn;
    private final AtomicInteger open;
    private final CompletableFuture<Void> ended = new CompletableFuture<>();

    /**
     * @param window how many are under way at a time.
     * @param goOn   whether to begin another one.
     */
    Stream(Endpoint from, Address to, Ledger ledger, int window, BooleanSupplier goOn) {
        this.from = from;
        this.to = to;
        this.ledger = ledger;
        this.goOn = goOn;
        this.open = new AtomicInteger(window);
        for (int i = 0; i < window; i++) {
            begin();
        }
    }

    private void begin() {
        if (goOn.getAsBoolean()) {
            from.send(to, ledger).whenComplete((outcome, failure) -> begin());
        } else if (open.decrementAndGet() == 0) {
            ended.complete(null);
        }
    }

    /** Waits until nothing is under way; false if something still is after so long. */
    boolean await(long seconds) {
        Time time = Simulation.here();
        return time.join(time.completeOnTimeout(ended.thenApply(all -> true), false, Duration.ofSeconds(seconds)));
    }
}
