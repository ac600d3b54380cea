package javino.link;

import java.lang.reflect.Method;
import java.security.SecureRandom;
import java.time.Duration;
import java.time.Instant;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Executors;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.ThreadLocalRandom;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import java.util.random.RandomGenerator;

/** The computer's own time, chance and threads; the one place that asks for them. Tests replace parts of it. */
public class RealTime implements Time {

    @Override
    public long nanos() {
        return System.nanoTime();
    }

    @Override
    public Instant instant() {
        return Instant.now();
    }

    @Override
    public RandomGenerator random() {
        return ThreadLocalRandom.current();
    }

    @Override
    public SecureRandom secureRandom() {
        return new SecureRandom();
    }

    @Override
    public void await(Object monitor, long nanos) throws InterruptedException {
        TimeUnit.NANOSECONDS.timedWait(monitor, nanos);
    }

    @Override
    public void wake(Object monitor) {
        monitor.notifyAll();
    }

    @Override
    public void pause(long nanos) {
        LockSupport.parkNanos(nanos);
    }

    /** {@inheritDoc} A virtual one where Java has them (21 and newer), so that a hundred cost little. */
    @Override
    public Thread thread(String name, Runnable task) {
        try {
            Object builder = Thread.class.getMethod("ofVirtual").invoke(null);
            // The interface gives the methods, as the class behind it is not public.
            Class<?> type = Class.forName("java.lang.Thread$Builder");
            Method named = type.getMethod("name", String.class);
            return (Thread) type.getMethod("unstarted", Runnable.class).invoke(named.invoke(builder, name), task);
        } catch (ReflectiveOperationException e) {
            return daemon(name, task);
        }
    }

    private static Thread daemon(String name, Runnable task) {
        Thread thread = new Thread(task, name);
        thread.setDaemon(true);
        return thread;
    }

    @Override
    public Timer timer(String name, Consumer<RuntimeException> failed) {
        ScheduledExecutorService thread = Executors.newSingleThreadScheduledExecutor(step -> daemon(name, step));
        return new Timer() {
            @Override
            public long millis() {
                return TimeUnit.NANOSECONDS.toMillis(nanos());
            }

            @Override
            public void after(long millis, Runnable step) {
                try {
                    thread.schedule(() -> carefully(step), Math.max(0, millis), TimeUnit.MILLISECONDS);
                } catch (RejectedExecutionException e) {
                    // It was closed.
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
        };
    }

    @Override
    public <T> CompletableFuture<T> completeOnTimeout(CompletableFuture<T> future, T value, Duration longest) {
        return future.completeOnTimeout(value, longest.toNanos(), TimeUnit.NANOSECONDS);
    }

    @Override
    public <T> CompletableFuture<T> orTimeout(CompletableFuture<T> future, Duration longest) {
        return future.orTimeout(longest.toNanos(), TimeUnit.NANOSECONDS);
    }

    @Override
    public <T> T join(CompletableFuture<T> future) {
        return future.join();
    }

    @Override
    public <T> T get(CompletableFuture<T> future) throws InterruptedException, ExecutionException {
        return future.get();
    }

    @Override
    public LinkOpener port(String name) {
        return SerialLink.opener(name);
    }
}
