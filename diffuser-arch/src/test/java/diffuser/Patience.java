package diffuser;

import java.lang.management.ManagementFactory;
import java.time.Duration;

import com.sun.management.OperatingSystemMXBean;

/**
 * How long a test waits before it fails: some seconds in which nothing happens. A step that ends late, or in which this
 * process computes, does not count, up to 120 s in all: so no test fails because the machine is busy.
 */
final class Patience {

    static final Duration STEP = Duration.ofMillis(10);
    private static final Duration LONGEST = Duration.ofSeconds(120);
    private static final OperatingSystemMXBean SYSTEM =
            (OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();

    private final long end = System.nanoTime() + LONGEST.toNanos();
    private long idleNanos;
    private long last = System.nanoTime();
    private long computed = SYSTEM.getProcessCpuTime();

    /** As long as any agent may be idle before it does what it is to do. */
    Patience() {
        this(Duration.ofSeconds(8));
    }

    /** @param idle how long nothing may happen. */
    Patience(Duration idle) {
        idleNanos = idle.toNanos();
    }

    /** Whether to wait for one more {@link #STEP}; to be asked before each. */
    boolean lasts() {
        long now = System.nanoTime();
        long cpu = SYSTEM.getProcessCpuTime();
        boolean idle = now - last < 2 * STEP.toNanos() && cpu - computed < (now - last) / 2;
        idleNanos -= idle ? now - last : 0;
        last = now;
        computed = cpu;
        return idleNanos > 0 && now < end;
    }
}
