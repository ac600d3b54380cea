package javino.board;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.concurrent.TimeUnit;

/**
 * The bounded queue between those who ask and the session's thread, which waits here only while no live board is there:
 * before Java 24 a virtual thread that waits in a monitor keeps its carrier. Completes nothing itself.
 */
final class RequestQueue {

    private final int capacity;
    private final Deque<PendingRequest<?>> waiting = new ArrayDeque<>();
    private boolean woken;
    private String closedWhy;
    private volatile Runnable waker = () -> {};

    RequestQueue(int capacity) {
        this.capacity = capacity;
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
    synchronized void add(PendingRequest<?> request) throws QueueFullException, BoardOfflineException {
        if (closedWhy != null) {
            throw new BoardOfflineException(request.description(), closedWhy);
        }
        if (waiting.size() >= capacity) {
            throw new QueueFullException(request.description(), capacity);
        }
        waiting.add(request);
        news();
    }

    /**
     * The next request; null if the deadline passed, or {@link #wake} or {@link #close} was called, before one came.
     */
    synchronized PendingRequest<?> next(Deadline deadline) {
        try {
            while (waiting.isEmpty() && closedWhy == null && !woken && !deadline.passed()) {
                TimeUnit.NANOSECONDS.timedWait(this, deadline.nanosLeft());
            }
        } catch (InterruptedException e) {
            // A listener or a future's dependant interrupted this thread; the session ends by close() alone.
            return null;
        }
        woken = false;
        return closedWhy == null ? waiting.poll() : null;
    }

    private void news() {
        notifyAll();
        waker.run();
    }

    /** Whether {@link #next} would not wait. */
    synchronized boolean hasNews() {
        return woken || !waiting.isEmpty() || closedWhy != null;
    }

    /** Waits, but not after {@link #close}. */
    synchronized void pause(Duration duration) {
        Deadline end = Deadline.in(duration);
        try {
            while (closedWhy == null && !end.passed()) {
                TimeUnit.NANOSECONDS.timedWait(this, end.nanosLeft());
            }
        } catch (InterruptedException e) {
            // As in next(): the pause is only shorter.
            return;
        }
    }

    /** Ends a {@link #next} that waits, or the coming one. */
    synchronized void wake() {
        woken = true;
        news();
    }

    /** Takes out all requests whose time is over. */
    synchronized List<PendingRequest<?>> expired() {
        List<PendingRequest<?>> expired = waiting.stream().filter(request -> request.expiry().passed()).toList();
        waiting.removeAll(expired);
        return expired;
    }

    /** Takes out all requests. */
    synchronized List<PendingRequest<?>> drain() {
        List<PendingRequest<?>> all = new ArrayList<>(waiting);
        waiting.clear();
        return all;
    }

    /** Refuses all further requests; the first reason given stands. */
    synchronized void close(String why) {
        closedWhy = closedWhy == null ? why : closedWhy;
        news();
    }

    boolean isClosed() {
        return closedWhy() != null;
    }

    /** Why it was closed; null while it is open. */
    synchronized String closedWhy() {
        return closedWhy;
    }
}
