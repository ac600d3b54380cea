package javino.board;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;

/** The bounded queue between those who ask and the session's thread, which also waits here. Completes nothing itself. */
final class RequestQueue {

    private final int capacity;
    private final Deque<Pending<?>> waiting = new ArrayDeque<>();
    private final ReentrantLock lock = new ReentrantLock();
    private final Condition changed = lock.newCondition();
    private boolean woken;
    private String closedWhy;

    RequestQueue(int capacity) {
        this.capacity = capacity;
    }

    /**
     * Appends a request.
     *
     * @throws QueueFullException    if too many wait already.
     * @throws BoardOfflineException if the queue was closed.
     */
    void add(Pending<?> request) throws QueueFullException, BoardOfflineException {
        lock.lock();
        try {
            if (closedWhy != null) {
                throw new BoardOfflineException(request.description(), closedWhy);
            }
            if (waiting.size() >= capacity) {
                throw new QueueFullException(request.description(), capacity);
            }
            waiting.add(request);
            changed.signal();
        } finally {
            lock.unlock();
        }
    }

    /** The next request; null if the deadline passed, or {@link #wake} or {@link #close} was called, before one came. */
    Pending<?> next(Deadline deadline) {
        lock.lock();
        try {
            while (waiting.isEmpty() && closedWhy == null && !woken && !deadline.passed()) {
                changed.awaitNanos(deadline.nanosLeft());
            }
            woken = false;
            return closedWhy == null ? waiting.poll() : null;
        } catch (InterruptedException e) {
            // A listener or a future's dependant interrupted this thread; the session ends by close() alone.
            return null;
        } finally {
            lock.unlock();
        }
    }

    /** Waits, but not after {@link #close}. */
    void pause(Duration duration) {
        Deadline end = Deadline.in(duration);
        lock.lock();
        try {
            while (closedWhy == null && !end.passed()) {
                changed.awaitNanos(end.nanosLeft());
            }
        } catch (InterruptedException e) {
            // As in next(): the pause is only shorter.
            return;
        } finally {
            lock.unlock();
        }
    }

    /** Ends a {@link #next} that waits, or the coming one. */
    void wake() {
        lock.lock();
        try {
            woken = true;
            changed.signal();
        } finally {
            lock.unlock();
        }
    }

    /** Takes out all requests whose time is over. */
    List<Pending<?>> expired() {
        lock.lock();
        try {
            List<Pending<?>> expired = waiting.stream().filter(request -> request.expiry().passed()).toList();
            waiting.removeAll(expired);
            return expired;
        } finally {
            lock.unlock();
        }
    }

    /** Takes out all requests. */
    List<Pending<?>> drain() {
        lock.lock();
        try {
            List<Pending<?>> all = new ArrayList<>(waiting);
            waiting.clear();
            return all;
        } finally {
            lock.unlock();
        }
    }

    /** Refuses all further requests; the first reason given stands. */
    void close(String why) {
        lock.lock();
        try {
            closedWhy = closedWhy == null ? why : closedWhy;
            changed.signal();
        } finally {
            lock.unlock();
        }
    }

    boolean isClosed() {
        return closedWhy() != null;
    }

    /** Why it was closed; null while it is open. */
    String closedWhy() {
        lock.lock();
        try {
            return closedWhy;
        } finally {
            lock.unlock();
        }
    }
}
