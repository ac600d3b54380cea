package javino.board;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;

/**
 * The bounded queue between those who ask and the session's thread. Completes nothing itself. No monitor: before Java
 * 24 a virtual thread that waits in one keeps its carrier.
 */
final class RequestQueue {

    /** No request: ends a {@link #next}. */
    private static final Pending<?> WAKE = new Pending<>("", null, null, null, null);

    private final int capacity;
    private final Semaphore room;
    private final BlockingQueue<Pending<?>> waiting = new LinkedBlockingQueue<>();
    private final CountDownLatch closed = new CountDownLatch(1);
    private volatile String closedWhy;
    private volatile Runnable waker = () -> {};

    RequestQueue(int capacity) {
        this.capacity = capacity;
        room = new Semaphore(capacity);
    }

    /** Has whatever comes here also wake what else the session's thread may wait in. */
    void setWaker(Runnable toWake) {
        waker = toWake;
    }

    /**
     * Appends a request.
     *
     * @throws QueueFullException    if too many wait already.
     * @throws BoardOfflineException if the queue was closed.
     */
    void add(Pending<?> request) throws QueueFullException, BoardOfflineException {
        if (!isClosed() && !room.tryAcquire()) {
            throw new QueueFullException(request.description(), capacity);
        }
        waiting.add(request);
        // After it was added: if it is closed later, the request is drained.
        if (isClosed() && waiting.remove(request)) {
            throw new BoardOfflineException(request.description(), closedWhy);
        }
        waker.run();
    }

    /**
     * The next request; null if the deadline passed, or {@link #wake} or {@link #close} was called, before one came.
     */
    Pending<?> next(Deadline deadline) {
        try {
            Pending<?> next = waiting.poll(Math.max(0, deadline.nanosLeft()), TimeUnit.NANOSECONDS);
            if (next != null && next != WAKE && isClosed()) {
                waiting.add(next);
            }
            return next == WAKE || isClosed() ? null : taken(next);
        } catch (InterruptedException e) {
            // A listener or a future's dependant interrupted this thread; the session ends by close() alone.
            return null;
        }
    }

    private Pending<?> taken(Pending<?> request) {
        if (request != null) {
            room.release();
        }
        return request;
    }

    /** Whether {@link #next} would not wait. */
    boolean hasNews() {
        return !waiting.isEmpty() || isClosed();
    }

    /** Waits, but not after {@link #close}. */
    void pause(Duration duration) {
        try {
            closed.await(duration.toNanos(), TimeUnit.NANOSECONDS);
        } catch (InterruptedException e) {
            // As in next(): the pause is only shorter.
            return;
        }
    }

    /** Ends a {@link #next} that waits, or the coming one if no request waits. */
    void wake() {
        if (waiting.isEmpty()) {
            waiting.add(WAKE);
        }
        waker.run();
    }

    /** Takes out all requests whose time is over. */
    List<Pending<?>> expired() {
        List<Pending<?>> expired = new ArrayList<>(waiting);
        expired.removeIf(request -> request == WAKE || !request.expiry().passed() || !waiting.remove(request));
        expired.forEach(this::taken);
        return expired;
    }

    /** Takes out all requests. */
    List<Pending<?>> drain() {
        List<Pending<?>> all = new ArrayList<>();
        waiting.drainTo(all);
        all.removeIf(request -> request == WAKE);
        all.forEach(this::taken);
        return all;
    }

    /** Refuses all further requests; the first reason given stands. */
    synchronized void close(String why) {
        closedWhy = closedWhy == null ? why : closedWhy;
        closed.countDown();
        wake();
    }

    boolean isClosed() {
        return closedWhy != null;
    }

    /** Why it was closed; null while it is open. */
    String closedWhy() {
        return closedWhy;
    }
}
