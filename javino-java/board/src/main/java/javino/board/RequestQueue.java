package javino.board;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.stream.Stream;
import javino.link.Time;

/**
 * The bounded queue between those who ask and the session's thread, which waits here only while no live board is there:
 * before Java 24 a virtual thread that waits in a monitor keeps its carrier. Completes nothing itself.
 */
final class RequestQueue {

    private final int capacity;
    private final Time time;
    private final Deque<PendingRequest<?>> waiting = new ArrayDeque<>();
    /** Transmissions, in their order, from the first one on for which the board had no room. */
    private final Deque<PendingRequest<?>> held = new ArrayDeque<>();
    private boolean hasRoom;
    private boolean woken;
    private String closedWhy;
    private volatile Runnable waker = () -> {};

    RequestQueue(int capacity, Time time) {
        this.capacity = capacity;
        this.time = time;
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
        if (waiting.size() + held.size() >= capacity) {
            throw new QueueFullException(request.description(), capacity);
        }
        boolean follows = request.isTransmission() && !held.isEmpty();
        (follows ? held : waiting).add(request);
        news();
    }

    /**
     * The next request; null if the deadline passed, or {@link #wake} or {@link #close} was called, before one came.
     */
    synchronized PendingRequest<?> next(Deadline deadline) {
        try {
            while (!hasRequest() && closedWhy == null && !woken && !deadline.passed()) {
                time.await(this, deadline.nanosLeft());
            }
        } catch (InterruptedException e) {
            // A listener or a future's dependant interrupted this thread; the session ends by close() alone.
            return null;
        }
        woken = false;
        if (closedWhy != null || !hasRequest()) {
            return null;
        }
        return hasRoom && !held.isEmpty() ? held.poll() : waiting.poll();
    }

    private boolean hasRequest() {
        return !waiting.isEmpty() || hasRoom && !held.isEmpty();
    }

    /** Holds a transmission, and all behind it, until {@link #setRoom}: the board has no room for it. */
    synchronized void hold(PendingRequest<?> transmission) {
        held.addFirst(transmission);
        waiting.stream().filter(PendingRequest::isTransmission).forEach(held::add);
        waiting.removeIf(PendingRequest::isTransmission);
        hasRoom = false;
    }

    /** Takes out the transmissions that are held. */
    synchronized List<PendingRequest<?>> takeHeld() {
        List<PendingRequest<?>> all = List.copyOf(held);
        held.clear();
        return all;
    }

    /** The board may have room for another transmission: one has ended. */
    synchronized void setRoom() {
        hasRoom = true;
    }

    private void news() {
        time.wake(this);
        waker.run();
    }

    /** Whether {@link #next} would not wait. */
    synchronized boolean hasNews() {
        return woken || hasRequest() || closedWhy != null;
    }

    /** Waits, but not after {@link #close}. */
    synchronized void pause(Duration duration) {
        Deadline end = Deadline.in(duration, time);
        try {
            while (closedWhy == null && !end.passed()) {
                time.await(this, end.nanosLeft());
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
        List<PendingRequest<?>> expired = Stream.concat(held.stream(), waiting.stream())
                .filter(request -> request.expiry().passed()).toList();
        held.removeAll(expired);
        waiting.removeAll(expired);
        return expired;
    }

    /** Takes out all requests. */
    synchronized List<PendingRequest<?>> drain() {
        List<PendingRequest<?>> all = new ArrayList<>(held);
        all.addAll(waiting);
        held.clear();
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
