package keyagreement;

import java.util.concurrent.Executors;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;

/** The computer's own time, and a thread for one agent. */
final class WallClock implements BoardKeyAgreement.Clock {

    private final ScheduledExecutorService thread;

    WallClock(String name) {
        thread = Executors.newSingleThreadScheduledExecutor(step -> {
            Thread named = new Thread(step, name);
            named.setDaemon(true);
            return named;
        });
    }

    @Override
    public long millis() {
        return TimeUnit.NANOSECONDS.toMillis(System.nanoTime());
    }

    @Override
    public void after(long millis, Runnable step) {
        try {
            thread.schedule(step, millis, TimeUnit.MILLISECONDS);
        } catch (RejectedExecutionException e) {
            // The agent was stopped.
        }
    }

    @Override
    public void close() {
        thread.shutdown();
    }
}
