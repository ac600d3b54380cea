package campaign;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.ArrayList;
import java.util.List;
import javino.link.Time;
import lockstep.Simulation;

/** The steps of hosts in emulated time, none of which waits, and what they take of the CPU. */
final class MeasuredSteps implements Time.Timer {

    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

    private final List<RuntimeException> failed = new ArrayList<>();
    private final Time.Timer steps = Simulation.here().timer("hosts", failed::add);
    private long nanos;

    @Override
    public long millis() {
        return steps.millis();
    }

    @Override
    public void after(long millis, Runnable step) {
        steps.after(millis, () -> {
            long begun = THREADS.getCurrentThreadCpuTime();
            try {
                step.run();
            } finally {
                nanos += THREADS.getCurrentThreadCpuTime() - begun;
            }
        });
    }

    /** The CPU's time that they have used, in ms. */
    double used() {
        return nanos / 1e6;
    }

    /** The exceptions that they have thrown. */
    List<RuntimeException> failed() {
        return failed;
    }

    @Override
    public void close() {
        steps.close();
    }
}
