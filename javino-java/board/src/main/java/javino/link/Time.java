package javino.link;

import java.security.SecureRandom;
import java.time.Duration;
import java.time.InstantSource;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.random.RandomGenerator;

/**
 * All that a host has from its computer without asking a board: the time, random numbers, threads and waits; and the
 * ports, as emulated boards live in emulated time. It is passed on and never static, so that one virtual machine can
 * have several. As an {@link InstantSource} it tells the date.
 *
 * <p>The thread of a session waits only in {@link #await}, {@link #pause}, {@link #join} and {@link Link#read}.
 */
public interface Time extends InstantSource {

    // No default methods: they would make this class and that one wait for each other where two threads load them.

    /** The computer's own. */
    Time REAL = new RealTime();

    /** In ns, from an arbitrary moment on; never goes back. */
    long nanos();

    /** Random numbers that an attacker may guess. To be asked anew by each thread. */
    RandomGenerator random();

    /** Random numbers for keys, and for what nobody may guess. */
    SecureRandom secureRandom();

    /**
     * Waits in a monitor, which the thread has, until {@link #wake}; it may end earlier.
     *
     * @param nanos the longest wait; none if it is not positive.
     */
    void await(Object monitor, long nanos) throws InterruptedException;

    /** Ends all waits in a monitor, which the thread has. */
    void wake(Object monitor);

    /** Waits for so many ns; an interrupt, which it leaves set, ends that earlier. */
    void pause(long nanos);

    /** A daemon thread, not started yet. */
    Thread thread(String name, Runnable task);

    /**
     * A thread for steps, which starts with the first of them.
     *
     * @param failed told of steps that threw.
     */
    Timer timer(String name, Consumer<RuntimeException> failed);

    /** Completes a future after that time, unless it is done before. @return the same future. */
    <T> CompletableFuture<T> completeOnTimeout(CompletableFuture<T> future, T value, Duration longest);

    /** As {@link #completeOnTimeout}, but it fails with a {@link java.util.concurrent.TimeoutException}. */
    <T> CompletableFuture<T> orTimeout(CompletableFuture<T> future, Duration longest);

    /** Waits for a future, as {@link CompletableFuture#join} does. */
    <T> T join(CompletableFuture<T> future);

    /** The same, but an interrupt ends it. */
    <T> T get(CompletableFuture<T> future) throws InterruptedException, ExecutionException;

    /** Leads to a port, as {@link SerialLink#opener(String)} does. */
    LinkOpener port(String name);

    /** One thread for what a host does by itself, and the time for that. For any thread. */
    interface Timer extends Executor {

        /** In ms; never goes back. */
        long millis();

        /** Has something done as soon as that time has passed; not if all has been closed. */
        void after(long millis, Runnable step);

        /** Has something done behind all that waits. */
        @Override
        default void execute(Runnable step) {
            after(0, step);
        }

        /** Nothing more is done. */
        void close();
    }
}
