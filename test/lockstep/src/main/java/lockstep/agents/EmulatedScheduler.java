package lockstep.agents;

import java.util.List;
import java.util.concurrent.AbstractExecutorService;
import java.util.concurrent.Callable;
import java.util.concurrent.Delayed;
import java.util.concurrent.Executors;
import java.util.concurrent.FutureTask;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.ScheduledFuture;
import java.util.concurrent.TimeUnit;

import lockstep.Simulation;

/** Jason's scheduler of deadlines and waits. */
final class EmulatedScheduler extends AbstractExecutorService implements ScheduledExecutorService {

    private final Simulation simulation;

    EmulatedScheduler(Simulation simulation) {
        this.simulation = simulation;
    }

    private final class Alarm<V> extends FutureTask<V> implements ScheduledFuture<V> {
        private final long due;

        Alarm(Callable<V> task, long delay, TimeUnit unit) {
            super(task);
            due = simulation.nanos() + unit.toNanos(Math.max(0, delay));
            simulation.at(due, this);
        }

        @Override
        public long getDelay(TimeUnit unit) {
            return unit.convert(due - simulation.nanos(), TimeUnit.NANOSECONDS);
        }

        @Override
        public int compareTo(Delayed other) {
            return Long.compare(getDelay(TimeUnit.NANOSECONDS), other.getDelay(TimeUnit.NANOSECONDS));
        }
    }

    @Override
    public ScheduledFuture<?> schedule(Runnable task, long delay, TimeUnit unit) {
        return new Alarm<>(Executors.callable(task), delay, unit);
    }

    @Override
    public <V> ScheduledFuture<V> schedule(Callable<V> task, long delay, TimeUnit unit) {
        return new Alarm<>(task, delay, unit);
    }

    @Override
    public ScheduledFuture<?> scheduleAtFixedRate(Runnable task, long first, long period, TimeUnit unit) {
        throw new UnsupportedOperationException("Jason does not ask for this");
    }

    @Override
    public ScheduledFuture<?> scheduleWithFixedDelay(Runnable task, long first, long delay, TimeUnit unit) {
        throw new UnsupportedOperationException("Jason does not ask for this");
    }

    @Override
    public void execute(Runnable task) {
        simulation.at(simulation.nanos(), task);
    }

    @Override
    public void shutdown() {
        // It has no thread.
    }

    @Override
    public List<Runnable> shutdownNow() {
        return List.of();
    }

    @Override
    public boolean isShutdown() {
        return false;
    }

    @Override
    public boolean isTerminated() {
        return false;
    }

    @Override
    public boolean awaitTermination(long longest, TimeUnit unit) {
        return true;
    }
}
