package lockstep;

import java.time.Duration;
import java.util.Arrays;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Ends a simulation that stands still by the wall's time, and says which thread waits where. */
final class Watchdog extends Thread {

    private static final int MOST_FRAMES = 24;

    private final Simulation simulation;
    private final Thread coordinator;
    private final long mostSeconds;
    private volatile Coroutine running;
    private volatile long steps;

    Watchdog(Simulation simulation, Thread coordinator, Duration standstill) {
        super("simulation watchdog");
        setDaemon(true);
        this.simulation = simulation;
        this.coordinator = coordinator;
        mostSeconds = standstill.toSeconds();
    }

    /** The coordinator goes on. */
    void step() {
        steps++;  // Only the coordinator writes it.
    }

    /** Whose turn it is; null for the coordinator's. */
    void running(Coroutine coroutine) {
        running = coroutine;
        step();
    }

    void end() {
        interrupt();
    }

    @Override
    public void run() {
        long seen = -1;
        int seconds = 0;
        try {
            while (seconds < mostSeconds) {
                sleep(1000);
                Coroutine coroutine = running;
                // A thread that computes is not stuck.
                boolean stands = steps == seen && isStuck(coroutine == null ? coordinator : coroutine);
                seconds = stands ? seconds + 1 : 0;
                seen = steps;
            }
            Coroutine coroutine = running;
            AssertionError still = new AssertionError(report(coroutine));
            simulation.fail(still);
            System.err.println(still.getMessage());
            coordinator.interrupt();
            if (coroutine != null) {
                coroutine.abandon();
            }
        } catch (InterruptedException ended) {
            // The run is over.
        }
    }

    private static boolean isStuck(Thread thread) {
        return thread.getState() != State.RUNNABLE
                || Arrays.stream(thread.getStackTrace()).anyMatch(frame -> frame.getClassName().equals(
                        Lockstep.class.getName()));
    }

    private String report(Coroutine turn) {
        String threads = Stream.concat(Stream.of(coordinator), simulation.coroutines().stream())
                .map(thread -> "\n" + (thread == (turn == null ? coordinator : turn) ? "* " : "  ") + thread.getName()
                        + " waits in" + frames(thread))
                .collect(Collectors.joining());
        return "the simulation has stood still for " + mostSeconds + " s; the thread with * has its turn:" + threads;
    }

    private static String frames(Thread thread) {
        return Arrays.stream(thread.getStackTrace()).limit(MOST_FRAMES).map(frame -> "\n      " + frame)
                .collect(Collectors.joining());
    }
}
