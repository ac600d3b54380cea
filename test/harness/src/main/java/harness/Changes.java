package harness;

import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.function.Supplier;
import javino.link.Time;
import lockstep.Simulation;

/** Where a test waits, in its own time, for what other threads do. */
final class Changes {

    private final Time time = Simulation.here();
    private CompletableFuture<Void> next = new CompletableFuture<>();

    /** The time of the test that made this. */
    Time time() {
        return time;
    }

    /** Changes something, which nobody sees halfway, and has those who wait look again. */
    synchronized void change(Runnable how) {
        how.run();
        CompletableFuture<Void> told = next;
        next = new CompletableFuture<>();
        told.complete(null);
    }

    /** Waits until something is there to be taken, not null. */
    <T> T await(Supplier<String> lack, Duration longest, Supplier<T> taken) throws InterruptedException {
        long end = time.nanos() + longest.toNanos();
        while (true) {
            CompletableFuture<Void> change;
            synchronized (this) {
                T now = taken.get();
                if (now != null) {
                    return now;
                }
                change = next.copy();
            }
            Duration left = Duration.ofNanos(end - time.nanos());
            if (left.isNegative() || left.isZero()) {
                throw new AssertionError(lack.get());
            }
            try {
                time.get(time.completeOnTimeout(change, null, left));
            } catch (ExecutionException impossible) {
                throw new AssertionError(impossible);
            }
        }
    }
}
