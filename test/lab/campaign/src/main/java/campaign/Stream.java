package campaign;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import javino.protocol.Address;

/** Unicasts one after the other from one endpoint to another: as one ends the next begins, so that some always wait. */
final class Stream {

    private final Endpoint from;
    private final Address to;
    private final Ledger ledger;
    private final BooleanSupplier goOn;
    private final CountDownLatch ended;

    /**
     * @param window how many are under way at a time.
     * @param goOn   whether to begin another one.
     */
    Stream(Endpoint from, Address to, Ledger ledger, int window, BooleanSupplier goOn) {
        this.from = from;
        this.to = to;
        this.ledger = ledger;
        this.goOn = goOn;
        this.ended = new CountDownLatch(window);
        for (int i = 0; i < window; i++) {
            begin();
        }
    }

    private void begin() {
        if (goOn.getAsBoolean()) {
            from.send(to, ledger).whenComplete((outcome, failure) -> begin());
        } else {
            ended.countDown();
        }
    }

    /** Waits until nothing is under way; false if something still is after so long. */
    boolean await(long seconds) throws InterruptedException {
        return ended.await(seconds, TimeUnit.SECONDS);
    }
}
