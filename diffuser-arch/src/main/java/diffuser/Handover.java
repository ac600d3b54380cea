package diffuser;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;

import javino.link.Link;
import javino.link.LinkException;
import javino.link.LinkOpener;

/**
 * Opens a link as soon as the session before has left its port, which may be the same one by another name. The waiting
 * is done where links are opened: on the new session's thread, never on the agent's.
 *
 * @param next how the link is opened.
 * @param free completes when the port before is free.
 */
record Handover(LinkOpener next, CompletableFuture<Void> free) implements LinkOpener {

    /** A session ends in a fraction of that, unless its port hangs; then it is no use to wait. */
    private static final long LONGEST_SECONDS = 2;

    @Override
    public Link open() throws LinkException {
        await(free);
        return next.open();
    }

    @Override
    public String name() {
        return next.name();
    }

    /** Returns when the port is free, or after two seconds. */
    static void await(CompletableFuture<Void> free) {
        free.copy().completeOnTimeout(null, LONGEST_SECONDS, TimeUnit.SECONDS).join();
    }
}
