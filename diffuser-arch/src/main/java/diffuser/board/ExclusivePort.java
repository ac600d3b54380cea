package diffuser.board;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;

import javino.link.Link;
import javino.link.LinkException;
import javino.link.LinkOpener;
import javino.link.Time;

/**
 * Opens a port as soon as who had it before has left it: the agent's own session before, on whichever port, as that may
 * be the same one by another name; and another agent of this MAS that is about to end. The waiting is done where links
 * are opened: on the new session's thread, never on the agent's.
 */
public final class ExclusivePort implements LinkOpener {

    /** A session ends in a fraction of that, unless its port hangs; then it is no use to wait. */
    private static final Duration LONGEST = Duration.ofSeconds(2);
    /** The holder of each port. */
    static final Map<Port, ExclusivePort> HOLDERS = new ConcurrentHashMap<>();

    /** A port, by the system's name for it; in another time it is another one. */
    record Port(Time time, String name) {
    }

    private final LinkOpener next;
    private final String agent;
    private final CompletableFuture<Void> before;
    /** Completes at {@link #leave}; a test sees whether somebody waits. */
    final CompletableFuture<Void> left = new CompletableFuture<>();
    private final Time time;
    private volatile Port held;
    private boolean hasWaited;

    /**
     * A turn at a port, which lasts from its first opening until {@link #leave}.
     *
     * @param next   how the link is opened.
     * @param agent  the agent that has the turn, and for which of its boards.
     * @param before completes when the agent's port before is free.
     * @param time   of the agent, and of all who may have that port.
     */
    public ExclusivePort(LinkOpener next, String agent, CompletableFuture<Void> before, Time time) {
        this.next = next;
        this.agent = agent;
        this.before = before;
        this.time = time;
    }

    @Override
    public Link open() throws LinkException {
        await(before, time);
        long end = time.nanos() + LONGEST.toNanos();
        ExclusivePort holder = take();
        // If agents are killed and others created on their port, one that is killed already may come first.
        for (long left = end - time.nanos(); holder != this && !hasWaited && left > 0; left = end - time.nanos()) {
            await(holder.left, Duration.ofNanos(left), time);
            holder = take();
        }
        hasWaited = true;
        if (holder != this) {
            throw new LinkException(name(), "agent " + holder.agent + " of this MAS has it; give each board a port of"
                    + " its own, or have it left there first");
        }
        return next.open();
    }

    /** Takes the port unless somebody has it; says who has it then. */
    private ExclusivePort take() {
        Port port = new Port(time, systemName(name()));
        if (!port.equals(held)) {
            release();
        }
        ExclusivePort holder = HOLDERS.putIfAbsent(port, this);
        if (holder == null || holder == this) {
            held = port;
            return this;
        }
        return holder;
    }

    private static String systemName(String name) {
        try {
            Path path = Path.of(name);
            boolean isShort = path.getNameCount() == 1 && !Files.exists(path);
            return (isShort ? Path.of("/dev", name) : path).toRealPath().toString();
        } catch (IOException | InvalidPathException e) {
            return name;
        }
    }

    private void release() {
        if (held != null) {
            HOLDERS.remove(held, this);
        }
    }

    /** The session has ended: the port is free for others. */
    void leave() {
        release();
        left.complete(null);
    }

    @Override
    public String name() {
        return next.name();
    }

    /** Returns when the port is free, or after two seconds. */
    public static void await(CompletableFuture<Void> free, Time time) {
        await(free, LONGEST, time);
    }

    private static void await(CompletableFuture<Void> free, Duration longest, Time time) {
        time.join(time.completeOnTimeout(free.copy(), null, longest));
    }
}
