package campaign;

import java.lang.management.ManagementFactory;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.RejectedExecutionException;

import javino.link.Time;

/** The boards' time for a host, on a thread of its own. */
final class EmulatedClock implements Time.Timer {

    private final Timetable time;
    private final ExecutorService thread = Executors.newSingleThreadExecutor(step -> {
        Thread named = new Thread(step, "host");
        named.setDaemon(true);
        return named;
    });
    private final List<RuntimeException> failed = new CopyOnWriteArrayList<>();
    private volatile long nanos;

    EmulatedClock(Timetable time) {
        this.time = time;
    }

    @Override
    public long millis() {
        return (long) (time.now() * 1000);
    }

    @Override
    public void after(long millis, Runnable step) {
        if (millis == 0) {
            run(step);
        } else {
            time.at(time.now() + millis / 1000.0, () -> run(step));
        }
    }

    private void run(Runnable step) {
        try {
            thread.execute(() -> {
                try {
                    step.run();
                } catch (RuntimeException e) {
                    failed.add(e);
                }
                nanos = ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
            });
        } catch (RejectedExecutionException e) {
            // It was closed.
        }
    }

    /** The CPU's time that the thread has used, in ms. */
    double used() {
        return nanos / 1e6;
    }

    /** The exceptions that steps have thrown. */
    List<RuntimeException> failed() {
        return failed;
    }

    @Override
    public void close() {
        thread.shutdown();
    }
}
