package diffuser.board;

import java.util.concurrent.Executors;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;

/** The computer's own time, and a thread for one agent. */
public final class WallClock implements HostClock {

    private final ScheduledExecutorService thread;

    private final Consumer<RuntimeException> failed;

    /** @param failed is told of steps that threw. */
    public WallClock(String name, Consumer<RuntimeException> failed) {
        this.failed = failed;
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
            thread.schedule(() -> carefully(step), Math.max(0, millis), TimeUnit.MILLISECONDS);
        } catch (RejectedExecutionException e) {
            // The agent was stopped.
        }
    }

    private void carefully(Runnable step) {
        try {
            step.run();
        } catch (RuntimeException e) {
            failed.accept(e);
        }
    }

    @Override
    public void close() {
        thread.shutdown();
    }
}
